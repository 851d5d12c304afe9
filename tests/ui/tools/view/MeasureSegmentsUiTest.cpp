// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/view/MeasureTool.h"

#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/views/ViewGrid.h"

#include <QTest>

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace measureSegmentsUiTest {

namespace {

using Voxel = std::array<int, 3>;

/// The small head from the front, with a ball of six voxels' radius as segment in its middle, which
/// lies behind the skull.
class Fixture : public test::WindowFixture {
public:
    explicit Fixture(gpu::Context context)
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
    {
        apply(test::ballMask(glm::ivec3(test::smallHead::side), 6.0));
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.mode = gpu::RenderMode::Surface;
        display.surfaceThreshold = 300.0;
        display.context = context;
        display.contextOpacity = 0.25;
        workspace.setVolumeDisplay(display);
        view().lookFrom({0.0, -1.0, 0.0});
        workspace.setActiveTool(&tool);
    }
    ~Fixture() { workspace.setActiveTool(nullptr); }
    Fixture(const Fixture&) = delete;
    Fixture& operator=(const Fixture&) = delete;

    [[nodiscard]] ui::VolumeView& view() { return window.views().volume(); }
    /// Measures between what is seen in front of two voxels; returns the voxels of its ends.
    [[nodiscard]] std::vector<Voxel> measured(const glm::dvec3& from, const glm::dvec3& to)
    {
        const QPointF begin = pixel(view(), from);
        const QPointF end = pixel(view(), to);
        test::drawStroke(test::DrawnBy::Mouse, view(), {begin, (begin + end) / 2.0, end});
        // What an answer asks for is asked after it came.
        for (int round = 0; round < 8; ++round) {
            session().poll();
            if (!session().settle())
                qFatal("not settled");
        }
        std::vector<Voxel> ends;
        if (session().document().measurements.empty())
            return ends;
        for (const glm::dvec3& lps : session().document().measurements.back().pointsLps) {
            const glm::ivec3 voxel(
                glm::floor(workspace.volume()->geometry.toIndex(lps) + glm::dvec3(0.5)));
            ends.push_back({voxel.x, voxel.y, voxel.z});
        }
        return ends;
    }
    /// How far a voxel lies from the head's middle: its skull from 13 to 16 mm.
    [[nodiscard]] double fromMiddleMm(const Voxel& voxel) const
    {
        return glm::length(place(glm::dvec3(voxel[0], voxel[1], voxel[2])));
    }

    ui::MeasureTool tool;
};

} // namespace

/// What is measured in the 3D view where segments are seen among the volume.
class MeasureSegmentsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void behindWhatStepsBackItIsTheSegment_data()
    {
        QTest::addColumn<gpu::Context>("context");
        QTest::newRow("cut away") << gpu::Context::CutAway;
        QTest::newRow("translucent") << gpu::Context::Translucent;
    }
    void behindWhatStepsBackItIsTheSegment()
    {
        QFETCH(const gpu::Context, context);
        Fixture fixture(context);
        const std::set<Voxel> ball = fixture.voxels(1);
        QVERIFY(ball.size() > 100);
        std::vector<Voxel> ends = fixture.measured({16.5, 19.5, 19.5}, {22.5, 19.5, 19.5});
        QCOMPARE(ends.size(), std::size_t(2));
        QVERIFY(ball.contains(ends[0]) && ball.contains(ends[1]));
        QVERIFY(std::abs(ends[0][0] - 16.5) <= 1.0 && std::abs(ends[1][0] - 22.5) <= 1.0);
        // Its face towards the viewer.
        QVERIFY(ends[0][1] < 19 && ends[1][1] < 19);
        // Beside the segment the skull is seen.
        ends = fixture.measured({16.5, 19.5, 19.5}, {29.5, 19.5, 19.5});
        QCOMPARE(ends.size(), std::size_t(2));
        QVERIFY(ball.contains(ends[0]) && !ball.contains(ends[1]));
        QVERIFY2(std::abs(fixture.fromMiddleMm(ends[1]) - 16.0) < 1.6,
            qPrintable(QString::number(fixture.fromMiddleMm(ends[1]))));
    }

    void behindAnOpaqueVolumeItIsTheVolume()
    {
        Fixture fixture(gpu::Context::Opaque);
        const std::vector<Voxel> ends = fixture.measured({16.5, 19.5, 19.5}, {22.5, 19.5, 19.5});
        QCOMPARE(ends.size(), std::size_t(2));
        for (const Voxel& each : ends)
            QVERIFY(std::abs(fixture.fromMiddleMm(each) - 16.0) < 1.6);
    }
};

BURIN_WINDOW_TEST(MeasureSegmentsUiTest)

} // namespace measureSegmentsUiTest

#include "MeasureSegmentsUiTest.moc"
