// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/SurfaceWindow.h"
#include "tests/support/program/TestProgram.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/Refinement.h"

#include <QtTest>

#include <algorithm>
#include <limits>

namespace refineClippedUiTest {

namespace {

/// From where to where the red vertices of a surface lie along the view, mm from the patient's
/// front to the back.
struct Depths {
    double nearest = std::numeric_limits<double>::max();
    double farthest = std::numeric_limits<double>::lowest();
    int count = 0;
};

/// The surface of a ball around the origin, seen from the front.
class ClippedFixture : public test::SurfaceWindow {
public:
    ClippedFixture()
        : view(window.views().volume())
    {
        view.lookFrom({0.0, -1.0, 0.0});
        settle();
    }
    /// Hides what lies before, or beyond, the coronal plane at this place.
    void hide(double y, bool before)
    {
        core::ClipRegion clip = workspace.clip();
        clip.planes[0] = core::ClipPlane{
            .pointLps = {0.0, y, 0.0}, .normalLps = {0.0, before ? -1.0 : 1.0, 0.0}, .on = true};
        workspace.setClip(clip);
    }
    /// Marks what is seen in the middle of the ball.
    [[nodiscard]] Depths mark()
    {
        workspace.refinement().setSettings(
            {.mode = ui::Refinement::Mode::Mark, .mark = core::SurfaceMark::Red, .radiusMm = 4.0});
        test::drawStroke(test::DrawnBy::Pen, view, {view.context().toPixel(glm::dvec3(0.0))}, {});
        settle();
        Depths depths;
        workspace.refinement().mirror().forEachVertex(
            [&depths](core::VertexId, const core::SurfaceUpdate::Vertex& vertex) {
                if (vertex.mark != core::SurfaceMark::Red)
                    return;
                depths.nearest = std::min(depths.nearest, vertex.positionLps.y);
                depths.farthest = std::max(depths.farthest, vertex.positionLps.y);
                ++depths.count;
            });
        return depths;
    }

    ui::VolumeView& view;
};

} // namespace

/// In the 3D view the tool acts on what clipping leaves of the surface.
class RefineClippedUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void withoutClippingItIsTheNearSide()
    {
        ClippedFixture fixture;
        const Depths red = fixture.mark();
        QVERIFY(red.count > 0);
        QVERIFY(red.farthest < 0.0);
    }

    /// The far side is seen from within then.
    void whereTheNearSideIsHiddenItIsTheFarOne()
    {
        ClippedFixture fixture;
        fixture.hide(0.0, true);
        const Depths red = fixture.mark();
        QVERIFY(red.count > 0);
        QVERIFY(red.nearest > 0.0);
    }

    void theCuttingPlaneHidesLikewise()
    {
        ClippedFixture fixture;
        ui::CuttingPlane& plane = fixture.workspace.plane();
        // It is seen from the front, and what lies above it is on the viewer's side.
        plane.setPose(ui::CuttingPlane::poseFacing(glm::dvec3(0.0), {0.0, 1.0, 0.0}));
        plane.setLook({.shown = true, .clipsAbove = true});
        const Depths red = fixture.mark();
        QVERIFY(red.count > 0);
        QVERIFY(red.nearest > 0.0);
    }

    /// What is seen before a plane is met as without it.
    void aPlaneBehindItTakesNothing()
    {
        ClippedFixture fixture;
        fixture.hide(0.0, false);
        const Depths red = fixture.mark();
        QVERIFY(red.count > 0);
        QVERIFY(red.farthest < 0.0);
    }

    void whereAllIsHiddenThereIsNothing()
    {
        ClippedFixture fixture;
        fixture.hide(-test::SurfaceWindow::ballRadius - 4.0, false);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::size_t rows = fixture.rows();
        QCOMPARE(fixture.mark().count, 0);
        QCOMPARE(fixture.rows(), rows);
        QVERIFY(!said.isEmpty());
    }
};

BURIN_WINDOW_TEST(RefineClippedUiTest)

} // namespace refineClippedUiTest

#include "RefineClippedUiTest.moc"
