// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Actions.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <vector>

namespace crosshairTurnUiTest {

using ui::MprPlanes;
using ui::SliceOrientation;
using ui::SliceView;

namespace {

const gpu::SliceScene& sceneOf(const test::WindowFixture& fixture, const SliceView& view)
{
    return std::get<gpu::SliceScene>(fixture.frames.lastRequest(view.viewId()).scene);
}

/// Where the ring on a line through the crosshair lies.
QPoint ringAt(const SliceView& view, const QPointF& direction)
{
    const double away = 0.4 * std::min(view.width(), view.height());
    return (view.crosshairPixel() + away * direction).toPoint();
}

/// A point turned about the crosshair, clockwise on the screen.
QPointF turned(const SliceView& view, const QPointF& from, double degrees)
{
    const QPointF cross = view.crosshairPixel();
    const QPointF way = from - cross;
    const double radians = degrees * M_PI / 180.0;
    return cross
        + QPointF(way.x() * std::cos(radians) - way.y() * std::sin(radians),
            way.x() * std::sin(radians) + way.y() * std::cos(radians));
}

/// Drags a ring about the crosshair.
void dragAround(
    SliceView& view, const QPoint& from, double degrees, Qt::KeyboardModifiers keys = {})
{
    QTest::mousePress(&view, Qt::LeftButton, keys, from);
    constexpr int steps = 8;
    for (int step = 1; step <= steps; ++step) {
        const QPointF at = turned(view, from, degrees * step / steps);
        QMouseEvent move(
            QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, keys);
        QApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, keys, turned(view, from, degrees).toPoint());
    QCoreApplication::processEvents();
}

/// The same with a mouse or a pen.
void dragAround(test::DrawnBy by, SliceView& view, const QPoint& from, double degrees)
{
    std::vector<QPointF> way;
    constexpr int steps = 8;
    for (int step = 0; step <= steps; ++step)
        way.push_back(turned(view, from, degrees * step / steps));
    test::drawStroke(by, view, way);
    QCoreApplication::processEvents();
}

/// A direction turned about the feet-head axis, from the patient's left towards the back.
glm::dvec3 turnedAboutZ(const glm::dvec3& direction, double degrees)
{
    const double radians = degrees * M_PI / 180.0;
    return {direction.x * std::cos(radians) - direction.y * std::sin(radians),
        direction.x * std::sin(radians) + direction.y * std::cos(radians), direction.z};
}

} // namespace

class CrosshairTurnUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aRingTurnsTheOtherTwo_data() { test::addMouseAndPen(); }
    void aRingTurnsTheOtherTwo();
    void withCtrlItTurnsOneAlone();
    void theLineFollowsThePointerHoweverTheSliceLies();
    void picturesAndClicksAgreeOnObliqueSlices();
    void penPaintsOnAnObliqueSlice();
    void onlyWithoutAToolAndWithACrosshair();
    void theWheelWalksAcrossAnObliqueSlice();
    void theyAreTurnedBack();
};

void CrosshairTurnUiTest::aRingTurnsTheOtherTwo()
{
    QFETCH(const test::DrawnBy, by);
    test::WindowFixture fixture(test::headFirstSupine());
    ui::ViewGrid& grid = fixture.window.views();
    const core::WindowLevel window = fixture.workspace.windowLevel();
    const glm::dvec3 crosshair = fixture.workspace.crosshairLps();
    const gpu::SliceScene axial = sceneOf(fixture, grid.axial());
    const gpu::SliceScene coronal = sceneOf(fixture, grid.coronal());
    const gpu::SliceScene sagittal = sceneOf(fixture, grid.sagittal());
    // The coronal slice is seen as the line to the right.
    dragAround(by, grid.axial(), ringAt(grid.axial(), {1.0, 0.0}), 30.0);
    const auto isTurned = [](const gpu::SliceScene& now, const gpu::SliceScene& before) {
        return glm::length(now.rightLps - turnedAboutZ(before.rightLps, 30.0)) < 1e-6
            && glm::length(now.downLps - turnedAboutZ(before.downLps, 30.0)) < 1e-6;
    };
    QVERIFY(isTurned(sceneOf(fixture, grid.coronal()), coronal));
    QVERIFY(isTurned(sceneOf(fixture, grid.sagittal()), sagittal));
    QVERIFY(sceneOf(fixture, grid.axial()) == axial);
    // All pass through the crosshair, which stays, and no grey scale was changed.
    QVERIFY(fixture.workspace.crosshairLps() == crosshair);
    QCOMPARE(fixture.workspace.windowLevel(), window);
    for (const SliceView* view : {&grid.coronal(), &grid.sagittal()}) {
        const gpu::SliceScene& scene = sceneOf(fixture, *view);
        QVERIFY(std::abs(glm::dot(
                    crosshair - scene.centreLps, glm::cross(scene.rightLps, scene.downLps)))
            < 1e-9);
    }
    // A step of the history it is not.
    QVERIFY(!fixture.workspace.session()->history().canUndo());
}

void CrosshairTurnUiTest::withCtrlItTurnsOneAlone()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::ViewGrid& grid = fixture.window.views();
    const gpu::SliceScene coronal = sceneOf(fixture, grid.coronal());
    // In an axial slice the line downwards is the sagittal one.
    dragAround(grid.axial(), ringAt(grid.axial(), {0.0, 1.0}), -25.0, Qt::ControlModifier);
    QVERIFY(sceneOf(fixture, grid.coronal()).rightLps == coronal.rightLps);
    const glm::dvec3 normal = grid.planes().axes(SliceOrientation::Sagittal).normalLps;
    QVERIFY(std::abs(std::abs(glm::dot(normal, glm::dvec3(1.0, 0.0, 0.0)))
                - std::cos(25.0 * M_PI / 180.0))
        < 1e-6);
    // It stops before it lies in the coronal plane.
    dragAround(grid.axial(),
        turned(grid.axial(), ringAt(grid.axial(), {0.0, 1.0}), -25.0).toPoint(), -65.0,
        Qt::ControlModifier);
    const glm::dvec3 stopped = grid.planes().axes(SliceOrientation::Sagittal).normalLps;
    QVERIFY(std::abs(glm::dot(stopped, glm::dvec3(0.0, 1.0, 0.0))) > 0.9);
    QVERIFY(std::abs(glm::dot(stopped, glm::dvec3(0.0, 1.0, 0.0))) <= 0.985);
}

void CrosshairTurnUiTest::theLineFollowsThePointerHoweverTheSliceLies()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::ViewGrid& grid = fixture.window.views();
    for (const bool mirrored : {false, true}) {
        for (int quarters = 0; quarters < 4; ++quarters) {
            grid.resetViews();
            grid.sagittal().setTurn({mirrored, quarters});
            QCoreApplication::processEvents();
            // Whichever line lies to the right on the screen is taken.
            const bool isAxial = quarters % 2 == 0;
            const SliceOrientation line =
                isAxial ? SliceOrientation::Axial : SliceOrientation::Coronal;
            const QPoint from = ringAt(grid.sagittal(), {1.0, 0.0});
            dragAround(grid.sagittal(), from, 40.0);
            const QPointF to = turned(grid.sagittal(), from, 40.0);
            const glm::dvec3 under = grid.sagittal().context().toLps(to);
            const double beside = glm::dot(
                under - fixture.workspace.crosshairLps(), grid.planes().axes(line).normalLps);
            QVERIFY(!grid.planes().alongPatient());
            QVERIFY(std::abs(beside) < grid.sagittal().context().mmPerPixel());
        }
    }
}

void CrosshairTurnUiTest::picturesAndClicksAgreeOnObliqueSlices()
{
    test::WindowFixture fixture(test::oblique());
    ui::ViewGrid& grid = fixture.window.views();
    grid.planes().turnOthers(SliceOrientation::Axial, 0.5);
    grid.planes().turnOne(SliceOrientation::Coronal, SliceOrientation::Sagittal, 0.3);
    QCoreApplication::processEvents();
    for (SliceView* clicked : {&grid.axial(), &grid.sagittal(), &grid.coronal()}) {
        const QPoint at(clicked->width() / 2 + 37, clicked->height() / 2 - 23);
        QTest::mouseClick(clicked, Qt::LeftButton, {}, at);
        QCoreApplication::processEvents();
        const glm::dvec3 crosshair = fixture.workspace.crosshairLps();
        QVERIFY(glm::length(clicked->context().toLps(at) - crosshair) < 1e-9);
        for (const SliceView* view : {&grid.axial(), &grid.sagittal(), &grid.coronal()}) {
            const QPointF cross = view->crosshairPixel();
            const QRgb shown = view->picture().pixel(int(cross.x()), int(cross.y()));
            const glm::ivec3 expected = test::FakeFrames::colourAt(crosshair);
            const double tolerance = view->shownContext().mmPerPixel() + 1.0;
            QVERIFY(std::abs(qRed(shown) - expected.x) <= tolerance);
            QVERIFY(std::abs(qGreen(shown) - expected.y) <= tolerance);
            QVERIFY(std::abs(qBlue(shown) - expected.z) <= tolerance);
        }
    }
}

void CrosshairTurnUiTest::penPaintsOnAnObliqueSlice()
{
    test::WindowFixture fixture(test::smallHead::volume());
    core::EditSession& session = *fixture.workspace.session();
    const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
    ui::PaintTool paint(fixture.workspace);
    fixture.workspace.setBrushSettings(
        ui::Workspace::Brush::Paint, {.radiusMm = 1.2, .disc = true});
    fixture.workspace.setActiveTool(&paint);
    SliceView& coronal = fixture.window.views().coronal();
    fixture.window.views().planes().turnOthers(SliceOrientation::Axial, 0.6);
    coronal.setTurn({true, 1});
    QCoreApplication::processEvents();
    const auto labelAt = [&](const glm::ivec3& voxel) {
        int label = -1;
        session.questions().probe(
            {voxel}, [&](const core::Result<std::vector<core::ProbedVoxel>>& probes) {
                label = int(probes->front().label);
            });
        for (int round = 0; round < 5 && label < 0; ++round) {
            if (!session.settle())
                qFatal("not settled");
            session.poll();
        }
        return label;
    };
    // The slice still holds the line from the feet to the head through the crosshair.
    const glm::ivec3 middle(glm::round(geometry.toIndex(fixture.workspace.crosshairLps())));
    const glm::ivec3 voxel = middle + glm::ivec3(0, 0, 6);
    const QPointF at = coronal.context().toPixel(geometry.toWorld(glm::dvec3(voxel)));
    test::Pen pen(coronal);
    pen.press(at, 0.5, 1000);
    pen.release(at, 1010);
    session.poll();
    QVERIFY(session.settle());
    QVERIFY(labelAt(voxel) > 0);
    QCOMPARE(labelAt(middle), 0);
    QCOMPARE(labelAt(middle - glm::ivec3(0, 0, 6)), 0);
    fixture.workspace.setActiveTool(nullptr);
}

void CrosshairTurnUiTest::onlyWithoutAToolAndWithACrosshair()
{
    test::WindowFixture fixture(test::smallHead::volume());
    ui::ViewGrid& grid = fixture.window.views();
    ui::PaintTool paint(fixture.workspace);
    const QPoint ring = ringAt(grid.axial(), {1.0, 0.0});
    fixture.workspace.setActiveTool(&paint);
    dragAround(grid.axial(), ring, 30.0);
    QVERIFY(grid.planes().alongPatient());
    fixture.workspace.setActiveTool(nullptr);
    QVERIFY(fixture.workspace.session()->settle());

    fixture.window.actionTable()[QStringLiteral("view.crosshair")].trigger();
    const core::WindowLevel window = fixture.workspace.windowLevel();
    dragAround(grid.axial(), ring, 30.0);
    QVERIFY(grid.planes().alongPatient());
    QVERIFY(fixture.workspace.windowLevel() != window);
    // Beside the rings it is the grey scale as well.
    fixture.window.actionTable()[QStringLiteral("view.crosshair")].trigger();
    const core::WindowLevel second = fixture.workspace.windowLevel();
    dragAround(grid.axial(), ringAt(grid.axial(), {0.7, 0.7}), 30.0);
    QVERIFY(grid.planes().alongPatient());
    QVERIFY(fixture.workspace.windowLevel() != second);
    // Rings come with the pointer.
    QTest::mouseMove(&grid.axial(), QPoint(30, 30));
    QTRY_VERIFY(fixture.workspace.pointedLps().has_value());
    const QImage with = grid.axial().grab().toImage();
    QEvent left(QEvent::Leave);
    QApplication::sendEvent(&grid.axial(), &left);
    QVERIFY(grid.axial().grab().toImage() != with);
}

void CrosshairTurnUiTest::theWheelWalksAcrossAnObliqueSlice()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::ViewGrid& grid = fixture.window.views();
    grid.planes().turnOthers(SliceOrientation::Axial, 0.4);
    SliceView& coronal = grid.coronal();
    const glm::dvec3 before = fixture.workspace.crosshairLps();
    const int number = coronal.sliceNumber();
    const QPointF at(coronal.width() / 2.0, coronal.height() / 2.0);
    QWheelEvent wheel(at, coronal.mapToGlobal(at), QPoint(), QPoint(0, 360), Qt::NoButton, {},
        Qt::NoScrollPhase, false);
    QApplication::sendEvent(&coronal, &wheel);
    QCOMPARE(coronal.sliceNumber(), number + 3);
    const glm::dvec3 way = fixture.workspace.crosshairLps() - before;
    const glm::dvec3 normal = grid.planes().axes(SliceOrientation::Coronal).normalLps;
    QVERIFY(glm::length(way) > 1.0);
    QVERIFY(std::abs(std::abs(glm::dot(way, normal)) - glm::length(way)) < 1e-9);
}

void CrosshairTurnUiTest::theyAreTurnedBack()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::ViewGrid& grid = fixture.window.views();
    const gpu::SliceScene coronal = sceneOf(fixture, grid.coronal());
    const auto turn = [&] {
        grid.planes().turnOthers(SliceOrientation::Axial, 0.4);
        return !(sceneOf(fixture, grid.coronal()).rightLps == coronal.rightLps);
    };
    QVERIFY(turn());
    fixture.window.actionTable()[QStringLiteral("view.alongPatient")].trigger();
    QVERIFY(grid.planes().alongPatient());
    QVERIFY(sceneOf(fixture, grid.coronal()).rightLps == coronal.rightLps);
    QVERIFY(turn());
    fixture.window.actionTable()[QStringLiteral("view.resetAll")].trigger();
    QVERIFY(grid.planes().alongPatient());
    QVERIFY(turn());
    fixture.workspace.setSession(nullptr);
    QVERIFY(grid.planes().alongPatient());
}

BURIN_WINDOW_TEST(CrosshairTurnUiTest)

} // namespace crosshairTurnUiTest

#include "CrosshairTurnUiTest.moc"
