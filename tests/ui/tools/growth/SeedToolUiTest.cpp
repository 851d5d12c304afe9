// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/growth/SeedTool.h"

#include "core/edits/kinds/growth/SeedStroke.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/tools/aim/PickQuestion.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/PendingSeeds.h"

#include <QToolButton>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace seedToolUiTest {

namespace {

class SeedFixture : public test::WindowFixture {
public:
    SeedFixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setActiveTool(&tool);
    }
    void sketch(ui::ImageView& view, const QPointF& from, const QPointF& to,
        test::Pen::End end = test::Pen::End::Tip)
    {
        test::Pen pen(view, end);
        const QPointF middle = QPointF(view.width(), view.height()) / 2.0;
        pen.press(middle + from, 0.5, 100);
        pen.move(middle + (from + to) / 2.0, 0.7, 108);
        pen.move(middle + to, 0.7, 116);
        pen.release(middle + to, 124);
        session().poll(); // the answer about what is seen
        if (!session().settle())
            qFatal("the sketch failed");
    }
    void stroke(ui::ImageView& view, Qt::KeyboardModifiers modifiers, const QPointF& from,
        const QPointF& to)
    {
        const QPointF middle = QPointF(view.width(), view.height()) / 2.0;
        QTest::mousePress(&view, Qt::LeftButton, modifiers, (middle + from).toPoint());
        QTest::mouseMove(&view, (middle + (from + to) / 2.0).toPoint());
        QTest::mouseMove(&view, (middle + to).toPoint());
        QTest::mouseRelease(&view, Qt::LeftButton, modifiers, (middle + to).toPoint());
        session().poll();
        if (!session().settle())
            qFatal("the stroke failed");
    }
    [[nodiscard]] std::vector<glm::ivec3> seeds(core::RowId row)
    {
        const auto& stroke = session().history().row(row).edit.get<core::SeedStroke>();
        std::vector<glm::ivec3> voxels;
        for (const glm::dvec3& point : stroke.pointsLps) {
            const glm::dvec3 index = workspace.volume()->geometry.toIndex(point);
            if (glm::length(index - glm::round(index)) > 1e-3)
                qFatal("a seed is no voxel's centre");
            voxels.push_back(glm::ivec3(glm::round(index)));
        }
        return voxels;
    }

    ui::SeedTool tool;
};

double distanceMm(const glm::ivec3& voxel)
{
    return glm::length(glm::dvec3(voxel - test::smallHead::side / 2) * glm::dvec3(1.0, 1.0, 1.5));
}

} // namespace

class SeedToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theFirstSketchMakesASegment()
    {
        SeedFixture fixture;
        fixture.sketch(fixture.window.views().axial(), {-10, 0}, {10, 0});
        const core::Document& document = fixture.session().document();
        QCOMPARE(document.segments.size(), std::size_t(1));
        QCOMPARE(fixture.workspace.activeSegment(), 1);
        QCOMPARE(fixture.session().history().position(), core::RowId(2));
        QVERIFY(fixture.session().history().row(1).edit.is<core::AddSegment>());
        QVERIFY(fixture.session().history().row(2).edit.is<core::SeedStroke>());
        // One undo takes back the seeds only.
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(document.segments.size(), std::size_t(1));
    }

    void aSketchOnASliceTakesEveryVoxelUnderIt()
    {
        SeedFixture fixture;
        ui::SliceView& view = fixture.window.views().axial();
        const ui::ViewContext context = view.context();
        fixture.sketch(view, {-30, 6}, {30, 6});
        const auto voxels = fixture.seeds(2);
        std::set<std::array<int, 3>> unique;
        for (const glm::ivec3& voxel : voxels) {
            unique.insert({voxel.x, voxel.y, voxel.z});
            QCOMPARE(voxel.z, voxels.front().z);
            QCOMPARE(voxel.y, voxels.front().y);
        }
        QCOMPARE(unique.size(), voxels.size());
        for (std::size_t i = 1; i < voxels.size(); ++i)
            QCOMPARE(std::abs(voxels[i].x - voxels[i - 1].x), 1);
        const double lengthMm = 60.0 * context.mmPerPixel();
        QVERIFY(std::abs(double(voxels.size()) - 1.0 - lengthMm) <= 1.0);
    }

    /// A pen sketches as wide as it is pressed, a mouse a line.
    void pressureIsTheWidth()
    {
        SeedFixture fixture;
        ui::SliceView& view = fixture.window.views().axial();
        const ui::ViewContext context = view.context();
        const QPointF middle = QPointF(view.width(), view.height()) / 2.0;
        const QPointF from = middle + QPointF(-30, 6);
        const QPointF to = middle + QPointF(30, 6);
        const auto sketched = [&](double pressure) {
            test::Pen pen(view);
            pen.press(from, pressure, 100);
            pen.move(to, pressure, 108);
            pen.release(to, 124);
            if (!fixture.session().settle())
                qFatal("the sketch failed");
            return fixture.seeds(fixture.session().history().position());
        };
        for (const glm::ivec3& voxel : sketched(1.0))
            QCOMPARE(voxel.y, fixture.seeds(2).front().y); // off, as it is at first
        auto* button = fixture.window.findChild<QToolButton*>(QStringLiteral("radiusByPressure"));
        QVERIFY(button && !button->isChecked());
        button->click();
        QVERIFY(fixture.tool.settingsJson()[QStringLiteral("byPressure")].toBool());
        for (const double pressure : {0.4, 1.0}) {
            QVERIFY(fixture.session().undo() && fixture.session().settle());
            const std::vector<glm::ivec3> voxels = sketched(pressure);
            const auto isSeed = [&voxels](const glm::ivec3& voxel) {
                return std::find(voxels.begin(), voxels.end(), voxel) != voxels.end();
            };
            const double reachMm = 3.0 * pressure;
            std::size_t inside = 0;
            for (int y = 0; y < test::smallHead::side; ++y) {
                for (int x = 0; x < test::smallHead::side; ++x) {
                    const glm::ivec3 voxel(x, y, voxels.front().z);
                    const QPointF at = context.toPixel(
                        fixture.workspace.volume()->geometry.toWorld(glm::dvec3(voxel)));
                    const double beyond = std::max({from.x() - at.x(), at.x() - to.x(), 0.0});
                    const double away =
                        std::hypot(beyond, at.y() - from.y()) * context.mmPerPixel();
                    // Between lie those whose centre the edge of the sketch comes near to.
                    if (away <= reachMm - 0.5) {
                        ++inside;
                        QVERIFY(isSeed(voxel));
                    } else if (away > reachMm + 0.75) {
                        QVERIFY(!isSeed(voxel));
                    }
                }
            }
            QVERIFY(inside > 5);
            for (const glm::ivec3& voxel : voxels)
                QCOMPARE(voxel.z, voxels.front().z);
        }
        // Its settings come back with a session.
        ui::SeedTool other(fixture.workspace);
        other.applySettings(fixture.tool.settingsJson());
        QCOMPARE(other.settingsJson(), fixture.tool.settingsJson());
        // A mouse knows no pressure.
        fixture.stroke(view, {}, {-30, -20}, {30, -20});
        const auto line = fixture.seeds(fixture.session().history().position());
        for (const glm::ivec3& voxel : line)
            QCOMPARE(voxel.y, line.front().y);
    }

    /// In the 3D view, too: more of what is seen, and nothing of what is not.
    void pressureIsTheWidthIn3d()
    {
        SeedFixture fixture;
        ui::VolumeView& view = fixture.window.views().volume();
        view.lookFrom({0.0, -1.0, 0.0});
        fixture.sketch(view, {-20, -8}, {20, 8});
        const std::size_t line = fixture.seeds(2).size();
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        fixture.tool.applySettings({{QStringLiteral("byPressure"), true}});
        fixture.sketch(view, {-20, -8}, {20, 8});
        const auto voxels = fixture.seeds(fixture.session().history().position());
        QVERIFY2(voxels.size() > 2 * line, qPrintable(QString::number(voxels.size())));
        for (const glm::ivec3& voxel : voxels)
            QVERIFY(std::abs(distanceMm(voxel) - 16.0) < 1.6);
    }

    void aSketchOnThe3DViewLandsOnWhatIsSeen()
    {
        SeedFixture fixture;
        ui::VolumeView& view = fixture.window.views().volume();
        view.lookFrom({0.0, -1.0, 0.0});
        fixture.sketch(view, {-20, -8}, {20, 8});
        const auto voxels = fixture.seeds(2);
        QVERIFY(voxels.size() > 4);
        for (const glm::ivec3& voxel : voxels) {
            // Bone's outer face, on the side that looks to the viewer.
            QVERIFY(std::abs(distanceMm(voxel) - 16.0) < 1.6);
            QVERIFY(voxel.y < test::smallHead::side / 2);
        }
    }

    void carvedTissueIsNotSeen()
    {
        SeedFixture fixture;
        ui::VolumeView& view = fixture.window.views().volume();
        view.lookFrom({0.0, -1.0, 0.0});
        QVERIFY(fixture.session().apply(test::drillWith(
            {.view = ui::orthographicView(std::get<gpu::VolumeScene>(view.context().scene)),
                .radiusMm = 6.0,
                .depthMm = 40.0,
                .surfaceThreshold = 300.0,
                .throughGaps = true,
                .samples = std::vector<core::PenSample>{{0.0, 0.0, 1.0, 0.0}}})));
        QVERIFY(fixture.session().settle());
        const auto rows = fixture.session().history().rows().size();
        fixture.sketch(view, {-1, 0}, {1, 0});
        // The hole goes right through the head: nothing is left to be seen there.
        QCOMPARE(fixture.session().history().rows().size(), rows);
    }

    void aSketchBesideTheVolumeIsTold()
    {
        SeedFixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        ui::SliceView& view = fixture.window.views().axial();
        const QPointF outside(0.0, -0.5 * view.height() + 4.0);
        const ui::ViewContext context = view.context();
        QVERIFY(!fixture.workspace.volume()->geometry.contains(
            glm::ivec3(glm::round(fixture.workspace.volume()->geometry.toIndex(
                context.toLps(QPointF(view.width(), view.height()) / 2.0 + outside))))));
        fixture.sketch(view, outside, outside + QPointF(5, 0));
        QVERIFY(fixture.session().history().rows().empty());
        QCOMPARE(said.count(), 1);
        QVERIFY(said[0][0].toString().contains(QStringLiteral("outside the volume")));
    }

    void escapeDropsTheSketch()
    {
        SeedFixture fixture;
        ui::SliceView& view = fixture.window.views().axial();
        test::Pen pen(view);
        const QPointF middle = QPointF(view.width(), view.height()) / 2.0;
        pen.press(middle, 0.5, 1);
        pen.move(middle + QPointF(9, 0), 0.5, 2);
        QTest::keyClick(&view, Qt::Key_Escape);
        pen.release(middle + QPointF(9, 0), 3);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.session().history().rows().empty());
    }

    void seedsGoToTheActiveSegment()
    {
        SeedFixture fixture;
        for (const char* name : {"A", "B"})
            QVERIFY(fixture.session().apply(test::newSegment(QLatin1String(name), 1)));
        QVERIFY(fixture.session().settle());
        fixture.workspace.setActiveSegment(2);
        fixture.sketch(fixture.window.views().coronal(), {0, 0}, {5, 5});
        const auto& edit = fixture.session().history().row(3).edit;
        QCOMPARE(edit.get<core::SeedStroke>().segment, 2);
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(2));
    }

    void controlTakesSeedsAway()
    {
        SeedFixture fixture;
        ui::SliceView& view = fixture.window.views().axial();
        fixture.sketch(view, {-30, 6}, {30, 6});
        const std::size_t sketched = fixture.workspace.seeds().seeds().size();
        const QByteArray before = fixture.session().stateHash();
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.stroke(view, Qt::ControlModifier, {0, 6}, {40, 6});
        QVERIFY2(fixture.session().history().rows().size() == 3,
            said.isEmpty() ? "nothing said" : qPrintable(said.last()[0].toString()));
        const auto& stroke = fixture.session().history().row(3).edit.get<core::SeedStroke>();
        QVERIFY(stroke.pointsLps.empty());
        QVERIFY(stroke.takenLps && !stroke.takenLps->empty());
        const std::size_t left = fixture.workspace.seeds().seeds().size();
        QCOMPARE(left, sketched - stroke.takenLps->size());
        QVERIFY(left > 0);
        for (const gpu::SceneSeed& seed : fixture.workspace.seeds().seeds())
            QVERIFY(view.context().toPixel(seed.lps).x() < view.width() / 2.0);
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), before);
        QCOMPARE(fixture.workspace.seeds().seeds().size(), sketched);
    }

    void theEraserTakesSeedsAway()
    {
        SeedFixture fixture;
        ui::SliceView& view = fixture.window.views().axial();
        fixture.sketch(view, {-10, 6}, {10, 6});
        fixture.sketch(view, {-20, 6}, {20, 6}, test::Pen::End::Eraser);
        QVERIFY(fixture.workspace.seeds().seeds().empty());
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(3));
    }

    void shiftMovesASeed()
    {
        SeedFixture fixture;
        ui::SliceView& view = fixture.window.views().axial();
        fixture.sketch(view, {-20, 6}, {-20, 6});
        QCOMPARE(fixture.workspace.seeds().seeds().size(), std::size_t(1));
        const glm::dvec3 from = fixture.workspace.seeds().seeds().front().lps;
        fixture.stroke(view, Qt::ShiftModifier, {-20, 6}, {20, -14});
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(3));
        QCOMPARE(
            fixture.session().history().row(3).name, QStringLiteral("Move 1 seed of 'Segment 1'"));
        QCOMPARE(fixture.workspace.seeds().seeds().size(), std::size_t(1));
        const glm::dvec3 to = fixture.workspace.seeds().seeds().front().lps;
        const glm::dvec2 movedMm = glm::dvec2(to - from);
        const double perPixel = view.context().mmPerPixel();
        QVERIFY(std::abs(std::abs(movedMm.x) - 40.0 * perPixel) <= 0.6);
        QVERIFY(std::abs(std::abs(movedMm.y) - 20.0 * perPixel) <= 0.6);
        QCOMPARE(to.z, from.z);
        // Where none lies, nothing is moved.
        fixture.stroke(view, Qt::ShiftModifier, {-20, 6}, {0, 0});
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(3));
    }

    void shiftMovesASeedIn3D()
    {
        SeedFixture fixture;
        ui::VolumeView& view = fixture.window.views().volume();
        view.lookFrom({0.0, -1.0, 0.0});
        fixture.sketch(view, {0, 0}, {0, 0});
        QCOMPARE(fixture.workspace.seeds().seeds().size(), std::size_t(1));
        fixture.stroke(view, Qt::ShiftModifier, {0, 0}, {15, 0});
        const auto voxels = fixture.seeds(3);
        QCOMPARE(voxels.size(), std::size_t(1));
        QVERIFY(std::abs(distanceMm(voxels.front()) - 16.0) < 1.6);
        QVERIFY(voxels.front() != fixture.seeds(2).front());
        // It is seen along a direction where it lies now, too: its own value is one of an edge.
        const auto along = fixture.workspace.seeds().seenAlong(1, voxels.front());
        QVERIFY(along);
        QVERIFY(glm::distance(glm::normalize(*along), {0.0, 1.0, 0.0}) < 1e-6);
        // Along a slice it becomes a seed of a slice.
        ui::SliceView& slice = fixture.window.views().coronal();
        const glm::dvec3 lps = fixture.workspace.seeds().seeds().front().lps;
        fixture.workspace.setCrosshairLps(lps);
        const QPointF at =
            slice.context().toPixel(lps) - QPointF(slice.width(), slice.height()) / 2.0;
        fixture.stroke(slice, Qt::ShiftModifier, at, at + QPointF(0.0, 12.0));
        QVERIFY(!fixture.workspace.seeds().seenAlong(1, fixture.seeds(4).front()));
    }

    /// A growth has accepted them: they are members, and shrinking gives them back first.
    void acceptedSeedsStay()
    {
        SeedFixture fixture;
        ui::SliceView& view = fixture.window.views().axial();
        fixture.sketch(view, {-10, 6}, {10, 6});
        QVERIFY(fixture.session().apply(test::growBetween(-2000, 3000, 1)));
        QVERIFY(fixture.session().settle());
        const auto rows = fixture.session().history().rows().size();
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.stroke(view, Qt::ControlModifier, {-20, 6}, {20, 6});
        QCOMPARE(fixture.session().history().rows().size(), rows);
        QVERIFY(said.last()[0].toString().contains(QStringLiteral("waits for a growth")));
    }

    /// What has grown stays what it is, and the window says so.
    void aSeedInWhatHasGrownIsTold()
    {
        SeedFixture fixture;
        ui::SliceView& view = fixture.window.views().axial();
        fixture.sketch(view, {-10, 6}, {10, 6});
        QVERIFY(fixture.session().apply(test::growBetween(-2000, 3000, 1)));
        QVERIFY(fixture.session().apply(test::newSegment(QStringLiteral("Other"), 1)));
        QVERIFY(fixture.session().settle());
        fixture.workspace.setActiveSegment(2);
        const auto rows = fixture.session().history().rows().size();
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.sketch(view, {-8, 6}, {8, 6});
        QCOMPARE(fixture.session().history().rows().size(), rows);
        QCOMPARE(said.count(), 1);
        QVERIFY(fixture.workspace.seeds().seeds().empty());
        QVERIFY2(said[0][0].toString().startsWith(QStringLiteral("No seed was set for Other: "))
                && said[0][0].toString().endsWith(QStringLiteral("to 'Segment 1'")),
            qPrintable(said[0][0].toString()));
        fixture.sketch(view, {-8, 6}, {40, 6});
        QCOMPARE(fixture.session().history().rows().size(), rows + 1);
        QVERIFY2(said.last()[0].toString().startsWith(QStringLiteral("Seeds for Other: "))
                && said.last()[0].toString().contains(QStringLiteral(" of ")),
            qPrintable(said.last()[0].toString()));
        QVERIFY(fixture.session().history().rows().back().name.contains(
            QStringLiteral("belong to 'Segment 1')")));
        // Only those that were taken have dots.
        const auto text = said.last()[0].toString().remove(QLatin1Char(' '));
        const auto shown = fixture.workspace.seeds().seeds().size();
        QVERIFY(shown > 0 && fixture.workspace.seeds().hollow().empty());
        QVERIFY2(text.contains(QStringLiteral("Other:%1of").arg(shown)), qPrintable(text));
        // Where all are taken there is nothing to explain.
        fixture.sketch(view, {-8, -30}, {8, -30});
        QVERIFY(said.last()[0].toString().endsWith(QStringLiteral("seed voxels for Other")));
    }

    void opacityIsCountedPerSample()
    {
        core::VoxelEncoding encoding;
        gpu::TransferFunction function{{{0.0, 0, 0.0}, {65535.0, 0, 1.0}}};
        const auto coarse = ui::opacityOfCodes(function, encoding, 1.0);
        const auto fine = ui::opacityOfCodes(function, encoding, 0.5);
        QCOMPARE(coarse.size(), std::size_t(256));
        QVERIFY(coarse[0] < 200u);
        // Two half-millimetre samples let through what one of a millimetre does.
        const double through = 1.0 - fine[128] / 65535.0;
        QVERIFY(std::abs(through * through - (1.0 - coarse[128] / 65535.0)) < 1e-4);
        QVERIFY(std::is_sorted(coarse.begin(), coarse.end()));
    }
};

BURIN_WINDOW_TEST(SeedToolUiTest)

} // namespace seedToolUiTest

#include "SeedToolUiTest.moc"
