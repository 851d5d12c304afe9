// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/tools/sculpt/CarveBrushTool.h"
#include "ui/tools/sculpt/PeelTool.h"
#include "ui/tools/sculpt/ScissorsTool.h"
#include "ui/views/ViewGrid.h"

#include <QtTest>

#include <cmath>
#include <vector>

namespace carvedByHandUiTest {

namespace {

/// The real window with the small head, whose bone the 3D view sees from the front.
class HandFixture : public test::WindowFixture {
public:
    HandFixture()
        : test::WindowFixture(test::smallHead::volume())
        , carve(workspace)
        , peel(workspace)
        , scissors(workspace)
        , slice(window.views().axial())
        , view(window.views().volume())
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setBrushSettings(ui::Workspace::Brush::Carve, {.radiusMm = 3.0});
        peel.setDepthMm(8.0);
        view.lookFrom({0.0, -1.0, 0.0});
    }
    [[nodiscard]] static QPointF middleOf(const QWidget& widget)
    {
        return QPointF(widget.width(), widget.height()) / 2.0;
    }
    /// To the right of the middle.
    [[nodiscard]] static std::vector<QPointF> line(const QWidget& widget)
    {
        const QPointF middle = middleOf(widget);
        return {middle, middle + QPointF(6.5, 2.0), middle + QPointF(24.25, 9.5),
            middle + QPointF(42.0, 1.0)};
    }
    /// Around the middle, not quite closed.
    [[nodiscard]] std::vector<QPointF> ring(double radiusPixels) const
    {
        std::vector<QPointF> way;
        for (int i = 0; i < 39; ++i) {
            const double t = 2.0 * M_PI * i / 40.0;
            way.push_back(middleOf(view) + radiusPixels * QPointF(std::cos(t), std::sin(t)));
        }
        return way;
    }
    [[nodiscard]] const core::Edit& lastEdit() { return session().history().rows().back().edit; }

    ui::CarveBrushTool carve;
    ui::PeelTool peel;
    ui::ScissorsTool scissors;
    ui::SliceView& slice;
    ui::VolumeView& view;
};

/// The same hand, turned round: a mouse with Ctrl, a pen's other end.
void drawInverted(test::DrawnBy by, QWidget& widget, const std::vector<QPointF>& way)
{
    const test::DrawnBy other =
        by == test::DrawnBy::Mouse ? test::DrawnBy::Mouse : test::DrawnBy::Eraser;
    test::drawStroke(other, widget, way, test::invertingKeys(other));
}

} // namespace

/// What is carved by a pen is carved by a mouse as well, and what an eraser's end brings back, so
/// does Ctrl. Drill and laser have tests of their own for that.
class CarvedByHandUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void theBrushOnASlice_data() { test::addMouseAndPen(); }
    void theBrushOnASlice()
    {
        QFETCH(const test::DrawnBy, by);
        HandFixture fixture;
        fixture.workspace.setActiveTool(&fixture.carve);
        test::drawStroke(by, fixture.slice, HandFixture::line(fixture.slice));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(1));
        QVERIFY(fixture.carvedVoxels() > 100);
        const auto carved = fixture.lastEdit().get<core::BrushStroke>();
        QVERIFY(!carved.restore);
        QCOMPARE(carved.path.radiusMm, 3.0);
        drawInverted(by, fixture.slice, HandFixture::line(fixture.slice));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2));
        QVERIFY(fixture.lastEdit().get<core::BrushStroke>().restore);
        QCOMPARE(fixture.carvedVoxels(), std::int64_t(0));
    }

    void theBrushInThreeDimensions_data() { test::addMouseAndPen(); }
    void theBrushInThreeDimensions()
    {
        QFETCH(const test::DrawnBy, by);
        HandFixture fixture;
        fixture.workspace.setActiveTool(&fixture.carve);
        test::drawStroke(by, fixture.view, HandFixture::line(fixture.view));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(1));
        QVERIFY(!fixture.lastEdit().get<core::BrushStroke>().restore);
        QVERIFY(fixture.carvedVoxels() > 30);
        drawInverted(by, fixture.view, HandFixture::line(fixture.view));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2));
        QVERIFY(fixture.lastEdit().get<core::BrushStroke>().restore);
    }

    void theScissors_data() { test::addMouseAndPen(); }
    void theScissors()
    {
        QFETCH(const test::DrawnBy, by);
        HandFixture fixture;
        fixture.workspace.setActiveTool(&fixture.scissors);
        test::drawStroke(by, fixture.view, fixture.ring(30.0));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(1));
        const auto cut = fixture.lastEdit().get<core::ScissorsCut>();
        QVERIFY(!cut.restore && !cut.depthMm);
        QVERIFY(cut.polygonMm.size() > 10);
        const std::int64_t carved = fixture.carvedVoxels();
        QVERIFY(carved > 50);
        drawInverted(by, fixture.view, fixture.ring(30.0));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2));
        QVERIFY(fixture.lastEdit().get<core::ScissorsCut>().restore);
        QVERIFY(fixture.carvedVoxels() < carved / 2);
    }

    void thePeel_data() { test::addMouseAndPen(); }
    void thePeel()
    {
        QFETCH(const test::DrawnBy, by);
        HandFixture fixture;
        fixture.workspace.setActiveTool(&fixture.peel);
        test::drawStroke(by, fixture.view, fixture.ring(60.0));
        QVERIFY(fixture.peel.isOpen());
        fixture.peel.confirm();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(1));
        const auto cut = fixture.lastEdit().get<core::PeelCut>();
        QVERIFY(!cut.restore);
        QCOMPARE(cut.depthMm, 8.0);
        QVERIFY(cut.polygonMm.size() > 10);
        const std::int64_t carved = fixture.carvedVoxels();
        QVERIFY(carved > 50);
        drawInverted(by, fixture.view, fixture.ring(60.0));
        QVERIFY(fixture.peel.isOpen());
        fixture.peel.confirm();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2));
        QVERIFY(fixture.lastEdit().get<core::PeelCut>().restore);
        QVERIFY(fixture.carvedVoxels() < carved / 2);
    }
};

BURIN_WINDOW_TEST(CarvedByHandUiTest)

} // namespace carvedByHandUiTest

#include "CarvedByHandUiTest.moc"
