// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Actions.h"
#include "ui/geometry/OrientationLetters.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

#include <cmath>
#include <vector>

namespace turnedSliceUiTest {

using ui::SliceTurn;
using ui::SliceView;

namespace {

const gpu::SliceScene& sceneOf(const test::WindowFixture& fixture, const SliceView& view)
{
    return std::get<gpu::SliceScene>(fixture.frames.lastRequest(view.viewId()).scene);
}

QPointF middleOf(const QWidget& view)
{
    return QPointF(view.width(), view.height()) / 2.0;
}

/// Whether the picture that came shows a place of the patient at a pixel.
bool pictureShows(const SliceView& view, const QPointF& at, const glm::dvec3& lps)
{
    const QRgb shown = view.picture().pixel(int(at.x()), int(at.y()));
    const glm::ivec3 expected = test::FakeFrames::colourAt(lps);
    const double tolerance = view.shownContext().mmPerPixel() + 1.0;
    return std::abs(qRed(shown) - expected.x) <= tolerance
        && std::abs(qGreen(shown) - expected.y) <= tolerance
        && std::abs(qBlue(shown) - expected.z) <= tolerance;
}

/// As if the window system had; whether it does depends on which window is active.
void giveKeyboard(QWidget& view)
{
    Q_EMIT qApp->focusChanged(nullptr, &view);
}

std::vector<SliceTurn> allTurns()
{
    std::vector<SliceTurn> turns;
    for (const bool mirrored : {false, true}) {
        for (int quarters = 0; quarters < 4; ++quarters)
            turns.push_back({mirrored, quarters});
    }
    return turns;
}

} // namespace

class TurnedSliceUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void pixelsGoWhereTheyAreTurned();
    void lettersFollow();
    void panAndZoomFollowThePointer();
    void penPaintsTheVoxelUnderIt();
    void aClickLeadsTheCrosshairThere();
    void aSlabStaysOnItsSlices();
    void resetLaysItUpright();
    void onlySlicesAreTurned();
};

void TurnedSliceUiTest::pixelsGoWhereTheyAreTurned()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& coronal = fixture.window.views().coronal();
    giveKeyboard(coronal);
    coronal.setPlace({.centreLps = {3.0, 4.0, 5.0}, .mmPerPixel = 0.4});
    struct Step {
        const char* action;
        QPointF to; ///< where the pixel at (31, −17) from the middle goes
    };
    for (const Step& step : {Step{"view.flipLeftRight", {-31.0, -17.0}},
             Step{"view.flipTopBottom", {31.0, 17.0}}, Step{"view.quarterRight", {17.0, 31.0}},
             Step{"view.quarterLeft", {-17.0, -31.0}}, Step{"view.upright", {31.0, -17.0}}}) {
        coronal.setTurn({});
        const glm::dvec3 place = coronal.context().toLps(middleOf(coronal) + QPointF(31.0, -17.0));
        fixture.window.actionTable()[QLatin1String(step.action)].trigger();
        QCoreApplication::processEvents();
        const QPointF at = middleOf(coronal) + step.to;
        QVERIFY2(glm::length(coronal.context().toLps(at) - place) < 1e-9, step.action);
        const QPointF back = coronal.context().toPixel(place) - at;
        QVERIFY(std::hypot(back.x(), back.y()) < 1e-9);
        QVERIFY2(pictureShows(coronal, at, place), step.action);
    }
    // The others are left alone.
    QVERIFY(fixture.window.views().axial().turn().isUpright());
}

void TurnedSliceUiTest::lettersFollow()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    const auto letters = [&] {
        const gpu::SliceScene& scene = sceneOf(fixture, axial);
        return ui::directionLetters(scene.rightLps) + ui::directionLetters(scene.downLps);
    };
    QCOMPARE(letters(), QStringLiteral("LP"));
    axial.setTurn(axial.turn().flippedLeftRight());
    QCOMPARE(letters(), QStringLiteral("RP"));
    axial.setTurn(axial.turn().turnedClockwise());
    // What was on the right, R, is at the bottom; what was at the top, A, on the right.
    QCOMPARE(letters(), QStringLiteral("AR"));
    axial.setTurn(axial.turn().flippedTopBottom());
    QCOMPARE(letters(), QStringLiteral("AL"));
}

void TurnedSliceUiTest::panAndZoomFollowThePointer()
{
    test::WindowFixture fixture(test::oblique());
    SliceView& sagittal = fixture.window.views().sagittal();
    for (const SliceTurn& turn : allTurns()) {
        sagittal.resetView();
        sagittal.setTurn(turn);
        const QPoint from = sagittal.rect().center();
        const glm::dvec3 held = sagittal.context().toLps(from);
        const QPoint to = from + QPoint(36, -14);
        QTest::mousePress(&sagittal, Qt::MiddleButton, {}, from);
        QMouseEvent move(QEvent::MouseMove, QPointF(to), sagittal.mapToGlobal(QPointF(to)),
            Qt::NoButton, Qt::MiddleButton, {});
        QApplication::sendEvent(&sagittal, &move);
        QTest::mouseRelease(&sagittal, Qt::MiddleButton, {}, to);
        QVERIFY(glm::length(sagittal.context().toLps(to) - held) < 1e-9);

        const QPointF at(sagittal.width() * 0.3, sagittal.height() * 0.6);
        const glm::dvec3 under = sagittal.context().toLps(at);
        QWheelEvent wheel(at, sagittal.mapToGlobal(at), QPoint(), QPoint(0, 240), Qt::NoButton,
            Qt::ControlModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&sagittal, &wheel);
        QVERIFY(glm::length(sagittal.context().toLps(at) - under) < 1e-9);
    }
}

void TurnedSliceUiTest::penPaintsTheVoxelUnderIt()
{
    test::WindowFixture fixture(test::smallHead::volume());
    core::EditSession& session = *fixture.workspace.session();
    const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
    ui::PaintTool paint(fixture.workspace);
    fixture.workspace.setBrushSettings(
        ui::Workspace::Brush::Paint, {.radiusMm = 1.2, .disc = true});
    fixture.workspace.setActiveTool(&paint);
    SliceView& axial = fixture.window.views().axial();
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
    quint64 milliseconds = 1000;
    for (const SliceTurn& turn : allTurns()) {
        axial.setTurn(turn);
        QCoreApplication::processEvents();
        // A place that no flip and no turn brings to itself or another one's.
        const glm::ivec3 crosshair(glm::round(geometry.toIndex(fixture.workspace.crosshairLps())));
        const glm::ivec3 voxel = crosshair + glm::ivec3(7, -3, 0);
        const glm::dvec3 place = geometry.toWorld(glm::dvec3(voxel));
        const QPointF at = axial.context().toPixel(place);
        QVERIFY(pictureShows(axial, at, place));
        QVERIFY(labelAt(voxel) == 0);
        test::Pen pen(axial);
        pen.press(at, 0.5, milliseconds += 10);
        pen.release(at, milliseconds += 10);
        session.poll();
        QVERIFY(session.settle());
        QVERIFY(labelAt(voxel) > 0);
        for (const glm::ivec3& other :
            {glm::ivec3(-7, -3, 0), glm::ivec3(7, 3, 0), glm::ivec3(-7, 3, 0), glm::ivec3(3, 7, 0),
                glm::ivec3(-3, -7, 0), glm::ivec3(3, -7, 0), glm::ivec3(-3, 7, 0)})
            QCOMPARE(labelAt(crosshair + other), 0);
        QVERIFY(session.undo());
        QVERIFY(session.settle());
    }
    fixture.workspace.setActiveTool(nullptr);
}

void TurnedSliceUiTest::aClickLeadsTheCrosshairThere()
{
    test::WindowFixture fixture(test::headFirstProne());
    ui::ViewGrid& grid = fixture.window.views();
    for (const SliceTurn& turn : allTurns()) {
        grid.axial().setTurn(turn);
        QCoreApplication::processEvents();
        const QPoint at = grid.axial().rect().center() + QPoint(21, 34);
        const glm::dvec3 place = grid.axial().context().toLps(at);
        QTest::mouseClick(&grid.axial(), Qt::LeftButton, {}, at);
        QCoreApplication::processEvents();
        QVERIFY(glm::length(fixture.workspace.crosshairLps() - place) < 1e-9);
        QVERIFY(pictureShows(grid.axial(), at, place));
        // The upright views agree.
        QVERIFY(pictureShows(grid.coronal(), grid.coronal().crosshairPixel(), place));
    }
}

void TurnedSliceUiTest::aSlabStaysOnItsSlices()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    fixture.window.actionTable()[QStringLiteral("view.slabMip")].trigger();
    fixture.workspace.setCrosshairLps(fixture.workspace.crosshairLps() + glm::dvec3(0.0, 0.0, 1.0));
    for (const SliceTurn& turn : allTurns()) {
        axial.setTurn(turn);
        const gpu::SliceScene& scene = sceneOf(fixture, axial);
        // The renderer goes along right × down.
        const glm::dvec3 middle =
            scene.centreLps + scene.slab.offsetMm * glm::cross(scene.rightLps, scene.downLps);
        QVERIFY(std::abs(middle.z - (fixture.workspace.crosshairLps().z - 1.0)) < 1e-9);
    }
}

void TurnedSliceUiTest::resetLaysItUpright()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    const double fitting = sceneOf(fixture, axial).mmPerPixel;
    axial.setTurn({true, 1});
    // 128 mm by 96 mm fit into another scale when they lie across.
    QVERIFY(sceneOf(fixture, axial).mmPerPixel != fitting);
    QVERIFY(!axial.place().has_value());
    axial.resetView();
    QVERIFY(axial.turn().isUpright());
    QCOMPARE(sceneOf(fixture, axial).mmPerPixel, fitting);
    // Another study is upright as well.
    axial.setTurn({false, 2});
    fixture.workspace.setSession(nullptr);
    QVERIFY(axial.turn().isUpright());
}

void TurnedSliceUiTest::onlySlicesAreTurned()
{
    QString said;
    test::WindowFixture fixture(test::headFirstSupine());
    giveKeyboard(fixture.window.views().volume());
    QVERIFY(&fixture.window.views().current() == &fixture.window.views().volume());
    connect(&fixture.workspace, &ui::Workspace::said, this,
        [&said](const QString& sentence) { said = sentence; });
    fixture.window.actionTable()[QStringLiteral("view.quarterRight")].trigger();
    QVERIFY(said.contains(QLatin1String("slices")));
    for (const SliceView* view : fixture.window.views().slices())
        QVERIFY(view->turn().isUpright());
}

BURIN_WINDOW_TEST(TurnedSliceUiTest)

} // namespace turnedSliceUiTest

#include "TurnedSliceUiTest.moc"
