// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/ApplyTemplate.h"
#include "core/measure/MeasuredSize.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/SurfaceWindow.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/panels/refine/RefinePanel.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/Refinement.h"

#include <QListWidget>
#include <QPushButton>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <vector>

namespace refineUnevenUiTest {

namespace {

using Mode = ui::Refinement::Mode;
using core::SurfaceMark;
using Voxels = std::set<std::array<int, 3>>;

constexpr double radius = test::SurfaceWindow::ballRadius;
constexpr double middle = 0.5 * (test::smallHead::side - 1); // of the ball, an index
constexpr int slice = 26; // in its upper half
/// Where the ball ends on that slice, on the patient's left.
const glm::dvec3 border(
    middle + std::sqrt(radius * radius - (slice - middle) * (slice - middle)), middle, slice);

/// The small head; its upper slices lie farther apart than its lower ones, so that its middle is
/// shown 8 mm above where it truly lies.
core::LoadedVolume unevenHead()
{
    core::LoadedVolume head = test::smallHead::volume();
    core::VolumeGeometry& geometry = head.volume.geometry;
    glm::dvec3 place = geometry.originLps();
    for (int k = 0; k < geometry.size.z; ++k) {
        geometry.slicePositions.push_back(place);
        place.z += k < geometry.size.z / 2 ? 1.1 : 1.9;
    }
    return head;
}

/// A ball in that head and its surface; the axial view shows a slice through its upper half.
class UnevenFixture : public test::SurfaceWindow {
public:
    UnevenFixture()
        : test::SurfaceWindow(unevenHead())
        , panel(workspace)
        , view(window.views().axial())
        , refinement(workspace.refinement())
    {
        workspace.setCrosshairLps(place({middle, middle, slice}));
        settle();
    }
    [[nodiscard]] glm::dvec3 index(const glm::dvec3& shownLps) const
    {
        return workspace.volume()->geometry.toIndex(shownLps);
    }
    /// Presses the pen at a voxel of the slice.
    void touch(
        Mode mode, double radiusMm, const glm::dvec3& voxel, SurfaceMark mark = SurfaceMark::Red)
    {
        refinement.setSettings({.mode = mode, .mark = mark, .radiusMm = radiusMm});
        test::drawStroke(test::DrawnBy::Pen, view, {pixel(view, voxel)});
        settle();
    }

    ui::RefinePanel panel;
    ui::SliceView& view;
    ui::Refinement& refinement;
};

} // namespace

/// Where slices are unevenly spaced views show them as if they were evenly spaced, and the surface
/// lies elsewhere than it is shown; the pen works on what it sees.
class RefineUnevenUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void theSurfaceIsShownAroundItsVoxels()
    {
        UnevenFixture fixture;
        double farthest = 0.0;
        fixture.refinement.mirror().forEachVertex(
            [&](core::VertexId id, const core::SurfaceUpdate::Vertex& vertex) {
                const glm::dvec3 off = fixture.index(vertex.positionLps) - middle;
                farthest = std::max(farthest, std::abs(glm::length(off) - radius));
                // The same vertex where it truly lies.
                const glm::dvec3 truth = fixture.refinement.trueMirror().vertex(id).positionLps;
                QVERIFY(glm::distance(core::truePlace(
                                          fixture.workspace.volume()->geometry, vertex.positionLps),
                            truth)
                    < 1e-6);
            });
        QVERIFY2(farthest < 1.2, QByteArray::number(farthest).constData());
        QVERIFY(fixture.refinement.mirror().vertexCount() > 0);
    }

    void theSphereChangesVoxelsWhereItIs()
    {
        UnevenFixture fixture;
        const Voxels before = fixture.voxels();
        fixture.touch(Mode::Sphere, 5.0, border + glm::dvec3(1.5, 0.0, 0.0));
        fixture.refinement.writeBack();
        fixture.settle();
        const Voxels after = fixture.voxels();
        Voxels lost;
        std::set_difference(before.begin(), before.end(), after.begin(), after.end(),
            std::inserter(lost, lost.end()));
        QVERIFY2(lost.size() >= 15, QByteArray::number(qulonglong(lost.size())).constData());
        double sum = 0.0;
        for (const std::array<int, 3>& voxel : lost) {
            QVERIFY2(std::abs(voxel[2] - slice) <= 5, QByteArray::number(voxel[2]).constData());
            QVERIFY(voxel[0] > middle);
            sum += voxel[2];
        }
        const double mean = sum / double(lost.size());
        QVERIFY2(std::abs(mean - slice) < 1.5, QByteArray::number(mean).constData());
    }

    void whatIsMarkedIsFoundThere()
    {
        UnevenFixture fixture;
        fixture.touch(Mode::Mark, 4.0, border);
        QCOMPARE(fixture.refinement.errors().size(), std::size_t(1));
        const auto apart = [&fixture](const glm::dvec3& shownLps) {
            return glm::length(fixture.index(shownLps) - border);
        };
        QVERIFY(apart(fixture.refinement.errors().front().middleLps) < 2.0);
        fixture.workspace.setCrosshairLps(fixture.place({2.0, 2.0, 2.0}));
        fixture.refinement.goToError(1);
        QVERIFY(apart(fixture.workspace.crosshairLps()) < 2.0);
        fixture.refinement.signOff(0);
        fixture.settle();
        QVERIFY(fixture.refinement.errors().empty());
        QVERIFY(fixture.refinement.mirror().markCounts()[std::size_t(SurfaceMark::Green)] > 0);
    }

    /// They are shown as they were drawn, and become a template in their true places.
    void contoursStayWhereTheyWereDrawn()
    {
        UnevenFixture fixture;
        fixture.touch(Mode::Mark, 6.0, border);
        std::vector<glm::dvec3> line;
        for (int y = -5; y <= 5; ++y)
            line.push_back(fixture.place(border + glm::dvec3(3.0 - 0.14 * y * y, y, 0.0)));
        fixture.refinement.addContour(line);
        fixture.refinement.previewTemplate();
        QVERIFY(fixture.refinement.isPreviewing());
        QCOMPARE(fixture.refinement.contours().front().front(), line.front());
        fixture.refinement.takeTemplate();
        fixture.settle();
        const auto* taken =
            fixture.session().history().rows().back().edit.as<core::ApplyTemplate>();
        QVERIFY(taken);
        QCOMPARE(taken->contoursLps.front().size(), line.size());
        for (std::size_t i = 0; i < line.size(); ++i) {
            const glm::dvec3 truth = core::truePlace(fixture.workspace.volume()->geometry, line[i]);
            QVERIFY(glm::distance(truth, line[i]) > 1.0);
            QVERIFY(glm::distance(taken->contoursLps.front()[i], truth) < 0.05);
        }
    }

    void doubtsAreToldWhereTheyAreSeen()
    {
        UnevenFixture fixture;
        auto* look = fixture.panel.findChild<QPushButton*>(QStringLiteral("lookForDoubts"));
        auto* list = fixture.panel.findChild<QListWidget*>(QStringLiteral("surfaceDoubts"));
        QVERIFY(look && list);
        fixture.touch(Mode::Mark, 6.0, border, SurfaceMark::Green);
        // The segment grows under what is green.
        fixture.apply(test::paintAt(1, {fixture.place(border + glm::dvec3(1.0, 0.0, 0.0))}, 7.0));
        fixture.panel.findChild<QPushButton*>(QStringLiteral("followMask"))->click();
        const auto found = [&] {
            fixture.session().poll();
            QCoreApplication::processEvents();
            return look->isEnabled();
        };
        QTRY_VERIFY(found());
        fixture.settle();
        QVERIFY(list->count() > 0);
        QVERIFY(list->item(0)->text().startsWith(QStringLiteral("Off the mask")));
        Q_EMIT list->itemClicked(list->item(0));
        const glm::dvec3 shown = fixture.index(fixture.workspace.crosshairLps());
        QVERIFY2(glm::distance(shown, border) < 3.0, QByteArray::number(shown.z).constData());
    }
};

BURIN_WINDOW_TEST(RefineUnevenUiTest)

} // namespace refineUnevenUiTest

#include "RefineUnevenUiTest.moc"
