// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/geometry/OrientationLetters.h"
#include "ui/input/Tool.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/StatusLine.h"

#include <QApplication>
#include <QPainter>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>

namespace viewsUiTest {

using ui::SliceView;

namespace {

/// Works everywhere and writes down what it is told.
class NotingTool : public ui::Tool {
public:
    [[nodiscard]] QString name() const override { return QStringLiteral("Noting"); }
    [[nodiscard]] QString iconName() const override { return QStringLiteral("drill"); }
    [[nodiscard]] QString hint() const override { return QStringLiteral("press"); }
    [[nodiscard]] bool worksIn(const ui::ViewContext&) const override { return true; }
    void press(const ui::PointerSample&, const ui::ViewContext&) override { heard += 'p'; }
    void drag(const ui::PointerSample&, const ui::ViewContext&) override { heard += 'd'; }
    void release(const ui::PointerSample&, const ui::ViewContext&) override { heard += 'r'; }
    void cancel() override { heard += 'c'; }
    void hover(const ui::PointerSample&, const ui::ViewContext&) override { isHere = true; }
    void leave() override { isHere = false; }
    void changeRadius(int steps) override { radius += steps; }
    void changeDepth(int steps) override { depth += steps; }
    void turn(int steps) override { turned += steps; }

    QByteArray heard;
    bool isHere = false; ///< the pointer
    int radius = 0;
    int depth = 0;
    int turned = 0;
};

void drag(QWidget& view, Qt::MouseButton button, const QPoint& from, const QPoint& by,
    Qt::KeyboardModifiers modifiers = {})
{
    QTest::mousePress(&view, button, modifiers, from);
    for (int step = 1; step <= 4; ++step) {
        const QPointF at(from + by * step / 4);
        QMouseEvent move(
            QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, button, modifiers);
        QApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, button, modifiers, from + by);
}

void wheel(QWidget& view, int steps, Qt::KeyboardModifiers modifiers = {})
{
    const QPointF at(view.width() / 2.0, view.height() / 2.0);
    QWheelEvent event(at, view.mapToGlobal(at), QPoint(), QPoint(0, 120 * steps), Qt::NoButton,
        modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
}

const gpu::SliceScene& sliceScene(const test::WindowFixture& fixture, const SliceView& view)
{
    return std::get<gpu::SliceScene>(fixture.frames.lastRequest(view.viewId()).scene);
}

glm::ivec3 voxelAt(const test::WindowFixture& fixture, const glm::dvec3& lps)
{
    return glm::ivec3(glm::round(fixture.workspace.volume()->geometry.toIndex(lps)));
}

/// The view's picture holds the colour of the crosshair's position where the crosshair is drawn.
bool pictureShowsCrosshair(const test::WindowFixture& fixture, const ui::ImageView& view)
{
    const QPointF at = view.crosshairPixel();
    const QRgb shown = view.picture().pixel(int(at.x()), int(at.y()));
    const glm::ivec3 expected = test::FakeFrames::colourAt(fixture.workspace.crosshairLps());
    const double tolerance = view.shownContext().mmPerPixel() + 1.0;
    return std::abs(qRed(shown) - expected.x) <= tolerance
        && std::abs(qGreen(shown) - expected.y) <= tolerance
        && std::abs(qBlue(shown) - expected.z) <= tolerance;
}

} // namespace

class ViewsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void viewsAgreeAboutTheCrosshair_data();
    void viewsAgreeAboutTheCrosshair();
    void lettersFollowTheDirection_data();
    void lettersFollowTheDirection();
    void wheelWalksThroughSlices();
    void aSlabHoldsWholeSlices();
    void anObliqueSlabLeavesNoGaps();
    void thePointerPointsIntoTheSliceThatIsShown();
    void keysWalkThroughSlices();
    void leftDragWithoutToolIsWindowLevel();
    void toolStrokeNeverTouchesWindowLevel();
    void aPenThatIsHeldStillSeesFullQuality();
    void aStrokeThatLosesItsPointer();
    void middlePansAndRightZooms();
    void wheelWithModifiersServesTheTool();
    void shiftMovesTheCrosshairAlong();
    void doubleClickMaximises();
    void aDoubleClickWithAToolIsTwoOfItsClicks();
    void spaceNavigatesWithAToolInHand();
    void aToolForgetsThePointerWithTheStudy();
    void aToolForgetsThePointerWithTheHand();
    void toolsDrawOverAnnotations();
    void volumeViewTurnsAndZooms();
    void maximumIntensityHasItsOwnWindow();
    void nothingIsDrawnWhileNothingChanges();
};

void ViewsUiTest::viewsAgreeAboutTheCrosshair_data()
{
    QTest::addColumn<int>("volume");
    QTest::newRow("head first supine") << 0;
    QTest::newRow("head first prone") << 1;
    QTest::newRow("sagittal acquisition") << 2;
    QTest::newRow("oblique") << 3;
}

static glm::dmat4 volumeNumber(int number)
{
    switch (number) {
    case 0:
        return test::headFirstSupine();
    case 1:
        return test::headFirstProne();
    case 2:
        return test::sagittalAcquisition();
    default:
        return test::oblique();
    }
}

void ViewsUiTest::viewsAgreeAboutTheCrosshair()
{
    QFETCH(int, volume);
    test::WindowFixture fixture(volumeNumber(volume));
    ui::ViewGrid& grid = fixture.window.views();
    // Clicks in every slice view, at places that are no voxel's centre.
    for (SliceView* clicked : {&grid.axial(), &grid.sagittal(), &grid.coronal()}) {
        const QPoint at(clicked->width() / 2 + 37, clicked->height() / 2 - 23);
        QTest::mouseClick(clicked, Qt::LeftButton, {}, at);
        QCoreApplication::processEvents();
        const glm::dvec3 crosshair = fixture.workspace.crosshairLps();
        const glm::ivec3 voxel = voxelAt(fixture, crosshair);
        QVERIFY(glm::length(clicked->context().toLps(at) - crosshair) < 1e-9);
        for (const SliceView* view : {&grid.axial(), &grid.sagittal(), &grid.coronal()}) {
            QCOMPARE(view->quality(), gpu::Frame::Quality::Refined);
            const glm::dvec3 read = view->shownContext().toLps(view->crosshairPixel());
            QCOMPARE(voxelAt(fixture, read), voxel);
            QVERIFY(pictureShowsCrosshair(fixture, *view));
        }
        // The 3D view knows no depth: the line of sight through its mark meets the voxel.
        const ui::ViewContext shown = grid.volume().shownContext();
        const auto& scene = std::get<gpu::VolumeScene>(shown.scene);
        const glm::dvec3 forward = glm::normalize(scene.targetLps - scene.eyeLps);
        const glm::dvec3 onPlane = shown.toLps(grid.volume().crosshairPixel());
        const glm::dvec3 read = onPlane + forward * glm::dot(crosshair - onPlane, forward);
        QCOMPARE(voxelAt(fixture, read), voxel);
    }
}

void ViewsUiTest::lettersFollowTheDirection_data()
{
    viewsAgreeAboutTheCrosshair_data();
}

void ViewsUiTest::lettersFollowTheDirection()
{
    QFETCH(int, volume);
    test::WindowFixture fixture(volumeNumber(volume));
    for (const SliceView* view : {&fixture.window.views().axial(),
             &fixture.window.views().sagittal(), &fixture.window.views().coronal()}) {
        // The picture itself says where its right edge is.
        const QImage picture = view->picture();
        const QRgb left = picture.pixel(picture.width() / 4, picture.height() / 2);
        const QRgb right = picture.pixel(3 * picture.width() / 4, picture.height() / 2);
        const glm::dvec3 direction(
            qRed(right) - qRed(left), qGreen(right) - qGreen(left), qBlue(right) - qBlue(left));
        const bool sagittal = view == &fixture.window.views().sagittal();
        QCOMPARE(
            ui::directionLetters(direction), sagittal ? QStringLiteral("P") : QStringLiteral("L"));
    }
}

/// What the readout says is of the voxel under a pointer at rest, too, when the slice changes.
void ViewsUiTest::thePointerPointsIntoTheSliceThatIsShown()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    const QPoint at = axial.rect().center() + QPoint(20, 10);
    QTest::mouseMove(&axial, at);
    QTRY_VERIFY(fixture.workspace.pointedLps().has_value());
    const glm::dvec3 before = *fixture.workspace.pointedLps();
    wheel(axial, -1);
    const glm::dvec3 after = fixture.workspace.pointedLps().value_or(glm::dvec3(1e9));
    QCOMPARE(after.x, before.x);
    QCOMPARE(after.y, before.y);
    QCOMPARE(after.z, fixture.workspace.crosshairLps().z);
    QVERIFY(after.z != before.z);
    QTest::keyClick(&axial, Qt::Key_Up);
    QCOMPARE(fixture.workspace.pointedLps()->z, fixture.workspace.crosshairLps().z);
    // The words, too: millimetres, voxel and value, as a pointer that comes back finds them there.
    const auto& status = *fixture.window.findChild<ui::StatusLine*>();
    const auto saysWhere = [&] {
        static_cast<void>(fixture.session().settle());
        fixture.session().poll();
        const glm::dvec3 lps = fixture.workspace.pointedLps().value_or(glm::dvec3(1e9));
        const glm::ivec3 voxel(glm::round(fixture.workspace.volume()->geometry.toIndex(lps)));
        return status.readout().startsWith(ui::positionText(lps)
            + QStringLiteral(" · voxel %1, %2, %3 · ").arg(voxel.x).arg(voxel.y).arg(voxel.z));
    };
    for (const bool byKey : {false, true}) {
        QTRY_VERIFY(saysWhere());
        const QString last = status.readout();
        if (byKey)
            QTest::keyClick(&axial, Qt::Key_Up);
        else
            wheel(axial, -1);
        QTRY_VERIFY(saysWhere());
        const QString said = status.readout();
        QVERIFY(said != last);
        fixture.hover(axial, at + QPoint(30, 0));
        QTRY_VERIFY(saysWhere() && status.readout() != said);
        fixture.hover(axial, at);
        QTRY_VERIFY(saysWhere() && status.readout() == said);
    }
}

void ViewsUiTest::wheelWalksThroughSlices()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    QCOMPARE(axial.sliceCount(), 40);
    QCOMPARE(axial.sliceNumber(), 20);
    const double before = fixture.workspace.crosshairLps().z;
    // Up is towards the head, as in the peers.
    wheel(axial, 1);
    QCOMPARE(axial.sliceNumber(), 21);
    QCOMPARE(fixture.workspace.crosshairLps().z, before + 3.0); // the volume's own spacing
    wheel(axial, -1, Qt::ShiftModifier);
    QCOMPARE(axial.sliceNumber(), 16);
    wheel(axial, -100);
    QCOMPARE(axial.sliceNumber(), 0);
    QCOMPARE(fixture.window.views().sagittal().sliceNumber(), 31);
}

/// As thick as its slices together, which the wheel counts; samples lie between them, too.
void ViewsUiTest::anObliqueSlabLeavesNoGaps()
{
    constexpr Qt::KeyboardModifiers both = Qt::ControlModifier | Qt::ShiftModifier;
    test::WindowFixture fixture(test::oblique());
    SliceView& axial = fixture.window.views().axial();
    fixture.window.actionTable()[QStringLiteral("view.slabMip")].trigger();
    const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
    const ui::SliceStack stack = ui::sliceStack(geometry, {0.0, 0.0, 1.0});
    const auto slices = [&] {
        const gpu::SceneSlab& slab = sliceScene(fixture, axial).slab;
        return (2 * slab.reach + 1) * slab.stepMm / stack.stepMm;
    };
    const double thick = slices();
    QVERIFY(std::abs(thick - std::round(thick)) < 1e-9 && int(std::lround(thick)) % 2 == 1);
    const gpu::SliceScene& scene = sliceScene(fixture, axial);
    const glm::dvec3 step =
        glm::cross(scene.rightLps, scene.downLps) * sliceScene(fixture, axial).slab.stepMm;
    const glm::dvec3 apart = glm::abs(geometry.toIndex(geometry.toWorld(glm::dvec3(0.0)) + step));
    QVERIFY(std::max({apart.x, apart.y, apart.z}) < 0.501);
    wheel(axial, 1, both);
    QVERIFY(std::abs(slices() - thick - 2.0) < 1e-9);
}

void ViewsUiTest::aSlabHoldsWholeSlices()
{
    constexpr Qt::KeyboardModifiers both = Qt::ControlModifier | Qt::ShiftModifier;
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    const SliceView& coronal = fixture.window.views().coronal();
    QVERIFY(sliceScene(fixture, axial).slab == gpu::SceneSlab());
    // 10 mm, of slices of 3 mm.
    fixture.window.actionTable()[QStringLiteral("view.slabMean")].trigger();
    gpu::SceneSlab slab = sliceScene(fixture, axial).slab;
    QVERIFY(slab.mode == gpu::SlabMode::Mean);
    QCOMPARE(slab.reach, 1);
    QCOMPARE(slab.stepMm, 3.0);
    QVERIFY(std::abs(slab.offsetMm) < 1e-9);
    wheel(axial, 1, both);
    QCOMPARE(sliceScene(fixture, axial).slab.reach, 2);
    QCOMPARE(fixture.workspace.viewOptions().slabMm, 15.0);
    QCOMPARE(axial.sliceNumber(), 20);
    slab = sliceScene(fixture, coronal).slab;
    QVERIFY(slab.mode == gpu::SlabMode::Mean);
    QVERIFY(std::abs((2 * slab.reach + 1) * slab.stepMm - 15.0) <= slab.stepMm + 1e-9);
    wheel(axial, -9, both);
    QCOMPARE(sliceScene(fixture, axial).slab.reach, 1);

    // With a tool, too, whose radius has Shift alone.
    NotingTool tool;
    fixture.workspace.setActiveTool(&tool);
    wheel(axial, 2, both);
    QCOMPARE(sliceScene(fixture, axial).slab.reach, 3);
    QCOMPARE(tool.radius, 0);
    wheel(axial, 1, Qt::ShiftModifier);
    QCOMPARE(tool.radius, 1);
    QCOMPARE(sliceScene(fixture, axial).slab.reach, 3);
    fixture.workspace.setActiveTool(nullptr);

    // Between slices it stays on them.
    fixture.workspace.setCrosshairLps(fixture.workspace.crosshairLps() + glm::dvec3(0.0, 0.0, 1.0));
    QVERIFY(std::abs(sliceScene(fixture, axial).slab.offsetMm + 1.0) < 1e-9);

    fixture.window.actionTable()[QStringLiteral("view.slabOff")].trigger();
    QVERIFY(sliceScene(fixture, axial).slab == gpu::SceneSlab());
    // The wheel turns it on as it was.
    wheel(axial, 1, both);
    QVERIFY(sliceScene(fixture, axial).slab.mode == gpu::SlabMode::Maximum);
    QCOMPARE(sliceScene(fixture, axial).slab.reach, 3);
}

void ViewsUiTest::keysWalkThroughSlices()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& coronal = fixture.window.views().coronal();
    coronal.setFocus();
    QTest::keyClick(&coronal, Qt::Key_Home);
    QCOMPARE(coronal.sliceNumber(), 0);
    QTest::keyClick(&coronal, Qt::Key_PageUp);
    QTest::keyClick(&coronal, Qt::Key_Up);
    QCOMPARE(coronal.sliceNumber(), 11);
    QTest::keyClick(&coronal, Qt::Key_Down);
    QCOMPARE(coronal.sliceNumber(), 10);
    QTest::keyClick(&coronal, Qt::Key_End);
    QCOMPARE(coronal.sliceNumber(), 47);
}

void ViewsUiTest::leftDragWithoutToolIsWindowLevel()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    const core::WindowLevel before = fixture.workspace.windowLevel();
    const glm::dvec3 crosshair = fixture.workspace.crosshairLps();
    drag(axial, Qt::LeftButton, axial.rect().center(), {80, 40});
    const core::WindowLevel after = fixture.workspace.windowLevel();
    QVERIFY(after.width > before.width);
    QVERIFY(after.centre > before.centre);
    QCOMPARE(fixture.workspace.crosshairLps(), crosshair); // a drag is no click
    QCOMPARE(sliceScene(fixture, axial).window, after);
}

void ViewsUiTest::toolStrokeNeverTouchesWindowLevel()
{
    test::WindowFixture fixture(test::headFirstSupine());
    NotingTool tool;
    fixture.workspace.setActiveTool(&tool);
    const core::WindowLevel before = fixture.workspace.windowLevel();
    for (ui::ImageView* view : fixture.window.views().views()) {
        tool.heard.clear();
        drag(*view, Qt::LeftButton, view->rect().center(), {60, 30});
        QCOMPARE(tool.heard, QByteArray("pddddr"));
    }
    QCOMPARE(fixture.workspace.windowLevel(), before);
    // With a tool in hand the right button is the grey scale.
    SliceView& axial = fixture.window.views().axial();
    drag(axial, Qt::RightButton, axial.rect().center(), {60, 30});
    QVERIFY(fixture.workspace.windowLevel() != before);
    fixture.workspace.setActiveTool(nullptr);
}

void ViewsUiTest::aPenThatIsHeldStillSeesFullQuality()
{
    test::WindowFixture fixture(test::headFirstSupine());
    NotingTool tool;
    fixture.workspace.setActiveTool(&tool);
    ui::ImageView& view = fixture.window.views().axial();
    const auto hurries = [&] { return fixture.frames.lastRequest(view.viewId()).interacting; };
    const auto show = [&] {
        fixture.workspace.setCrosshairLps(
            fixture.workspace.crosshairLps() + glm::dvec3(0.0, 0.0, 1.0));
    };
    const QPoint at(60, 60);
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    show();
    QVERIFY(hurries());
    QTRY_VERIFY(!hurries());
    QTest::mouseMove(&view, at + QPoint(5, 0));
    show();
    QVERIFY(hurries());
    QTRY_VERIFY(!hurries());
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at);
    show();
    QVERIFY(!hurries());
    QCOMPARE(tool.heard, QByteArray("pdr"));
    fixture.workspace.setActiveTool(nullptr);
}

void ViewsUiTest::aStrokeThatLosesItsPointer()
{
    test::WindowFixture fixture(test::headFirstSupine());
    NotingTool tool;
    fixture.workspace.setActiveTool(&tool);
    SliceView& view = fixture.window.views().axial();
    test::Pen pen(view);
    const auto begin = [&] {
        tool.heard.clear();
        pen.press({40, 40}, 0.5, 10);
        pen.move({44, 40}, 0.5, 20);
    };

    // Lifted without a release: what was drawn counts, once.
    begin();
    QEvent left(QEvent::TabletLeaveProximity);
    QCoreApplication::sendEvent(qApp, &left);
    pen.release({44, 40}, 30);
    QCOMPARE(tool.heard, QByteArray("pdr"));
    // A drag that moves the picture ends with it, too: the mouse is heard again.
    fixture.workspace.setActiveTool(nullptr);
    const glm::dvec3 crosshair = fixture.workspace.crosshairLps();
    pen.press({40, 40}, 0.5, 40);
    pen.move({60, 60}, 0.5, 50);
    QCoreApplication::sendEvent(qApp, &left);
    fixture.workspace.setActiveTool(&tool);
    tool.heard.clear();
    QTest::mousePress(&view, Qt::LeftButton, {}, {40, 40});
    QTest::mouseRelease(&view, Qt::LeftButton, {}, {40, 40});
    QCOMPARE(tool.heard, QByteArray("pr"));
    QVERIFY(fixture.workspace.crosshairLps() == crosshair);
    // A mouse knows no proximity.
    tool.heard.clear();
    QTest::mousePress(&view, Qt::LeftButton, {}, {40, 40});
    QCoreApplication::sendEvent(qApp, &left);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, {40, 40});
    QCOMPARE(tool.heard, QByteArray("pr"));

    // Another window takes over, or the view goes: as if it had not been begun.
    begin();
    QEvent deactivated(QEvent::WindowDeactivate);
    QCoreApplication::sendEvent(&view, &deactivated);
    pen.move({48, 40}, 0.5, 30);
    pen.release({48, 40}, 40);
    QCOMPARE(tool.heard, QByteArray("pdc"));
    begin();
    view.hide();
    QCOMPARE(tool.heard, QByteArray("pdc"));
    view.show();
    begin();
    pen.release({44, 40}, 30);
    QCOMPARE(tool.heard, QByteArray("pdr"));

    // Moves may be joined again once no stroke runs.
    const bool joined = QCoreApplication::testAttribute(Qt::AA_CompressHighFrequencyEvents);
    begin();
    QVERIFY(!QCoreApplication::testAttribute(Qt::AA_CompressHighFrequencyEvents));
    pen.release({44, 40}, 30);
    QCOMPARE(QCoreApplication::testAttribute(Qt::AA_CompressHighFrequencyEvents), joined);
    fixture.workspace.setActiveTool(nullptr);
}

void ViewsUiTest::middlePansAndRightZooms()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    const gpu::SliceScene before = sliceScene(fixture, axial);
    drag(axial, Qt::MiddleButton, axial.rect().center(), {40, -20});
    const gpu::SliceScene panned = sliceScene(fixture, axial);
    // What was under the pointer stays there.
    QVERIFY(std::abs(panned.centreLps.x - (before.centreLps.x - 40 * before.mmPerPixel)) < 1e-9);
    QVERIFY(std::abs(panned.centreLps.y - (before.centreLps.y + 20 * before.mmPerPixel)) < 1e-9);
    drag(axial, Qt::RightButton, axial.rect().center(), {0, -40});
    QVERIFY(sliceScene(fixture, axial).mmPerPixel < before.mmPerPixel);
    fixture.window.actionTable()[QStringLiteral("view.resetAll")].trigger();
    QCOMPARE(sliceScene(fixture, axial).mmPerPixel, before.mmPerPixel);
}

void ViewsUiTest::wheelWithModifiersServesTheTool()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    const int slice = axial.sliceNumber();
    NotingTool tool;
    fixture.workspace.setActiveTool(&tool);
    wheel(axial, 1, Qt::ShiftModifier);
    QCOMPARE(tool.radius, 1);
    QCOMPARE(axial.sliceNumber(), slice);
    // Alt means nothing: the slice walks, as by the wheel alone, and the radius is the radius.
    wheel(axial, 1, Qt::AltModifier);
    QCOMPARE(tool.depth, 0);
    QCOMPARE(axial.sliceNumber(), slice + 1);
    wheel(axial, 1, Qt::AltModifier | Qt::ShiftModifier);
    QCOMPARE(tool.radius, 2);
    QCOMPARE(tool.turned, 0);
    QCOMPARE(axial.sliceNumber(), slice + 1);
    wheel(axial, -1, Qt::AltModifier);
    QCOMPARE(axial.sliceNumber(), slice);
    fixture.workspace.setActiveTool(nullptr);
    const double before = sliceScene(fixture, axial).mmPerPixel;
    wheel(axial, 2, Qt::ControlModifier);
    QVERIFY(sliceScene(fixture, axial).mmPerPixel < before);
    QCOMPARE(axial.sliceNumber(), slice);
}

void ViewsUiTest::shiftMovesTheCrosshairAlong()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& coronal = fixture.window.views().coronal();
    const QPointF at(coronal.width() / 2.0 + 31, coronal.height() / 2.0 + 17);
    QMouseEvent move(QEvent::MouseMove, at, coronal.mapToGlobal(at), Qt::NoButton, Qt::NoButton,
        Qt::ShiftModifier);
    QApplication::sendEvent(&coronal, &move);
    QVERIFY(glm::length(fixture.workspace.crosshairLps() - coronal.context().toLps(at)) < 1e-9);
}

void ViewsUiTest::doubleClickMaximises()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::ViewGrid& grid = fixture.window.views();
    const glm::dvec3 crosshair = fixture.workspace.crosshairLps();
    // As the window system tells it: a click comes before.
    QTest::mouseClick(&grid.sagittal(), Qt::LeftButton, {}, QPoint(31, 43));
    QVERIFY(fixture.workspace.crosshairLps() != crosshair);
    QTest::mouseDClick(&grid.sagittal(), Qt::LeftButton, {}, QPoint(31, 43));
    QCOMPARE(grid.maximised(), &grid.sagittal());
    QVERIFY(fixture.workspace.crosshairLps() == crosshair);
    QVERIFY(!grid.axial().isVisible());
    QTRY_VERIFY(grid.sagittal().width() == grid.width());
    QTest::mouseDClick(&grid.sagittal(), Qt::LeftButton);
    QVERIFY(!grid.maximised());
    QVERIFY(grid.axial().isVisible());
}

/// A tool in the hand gets every press, as quick taps of a drill must not be lost; Space lends the
/// view.
void ViewsUiTest::aDoubleClickWithAToolIsTwoOfItsClicks()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::ViewGrid& grid = fixture.window.views();
    SliceView& axial = grid.axial();
    NotingTool tool;
    fixture.workspace.setActiveTool(&tool);
    const glm::dvec3 crosshair = fixture.workspace.crosshairLps();
    QTest::mouseClick(&axial, Qt::LeftButton, {}, QPoint(31, 43));
    QTest::mouseDClick(&axial, Qt::LeftButton, {}, QPoint(31, 43));
    QVERIFY(!grid.maximised());
    QVERIFY(fixture.workspace.crosshairLps() == crosshair);
    QVERIFY(tool.heard.count('p') >= 2);
    tool.heard.clear();
    axial.setFocus();
    QTest::keyPress(&axial, Qt::Key_Space);
    QTest::mouseClick(&axial, Qt::LeftButton, {}, QPoint(31, 43));
    QTest::mouseDClick(&axial, Qt::LeftButton, {}, QPoint(31, 43));
    QTest::keyRelease(&axial, Qt::Key_Space);
    QCOMPARE(grid.maximised(), &axial);
    QVERIFY(!tool.heard.contains('p'));
    fixture.workspace.setActiveTool(nullptr);
}

void ViewsUiTest::spaceNavigatesWithAToolInHand()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    NotingTool tool;
    fixture.workspace.setActiveTool(&tool);
    axial.setFocus();
    const core::WindowLevel window = fixture.workspace.windowLevel();
    const glm::dvec3 centre = sliceScene(fixture, axial).centreLps;
    QTest::keyPress(&axial, Qt::Key_Space);
    drag(axial, Qt::LeftButton, axial.rect().center(), {30, 0});
    QTest::keyRelease(&axial, Qt::Key_Space);
    QVERIFY(tool.heard.isEmpty());
    QVERIFY(sliceScene(fixture, axial).centreLps != centre);
    QCOMPARE(fixture.workspace.windowLevel(), window);
    // Who pans while taking another tool goes on panning.
    QTest::mousePress(&axial, Qt::MiddleButton, {}, axial.rect().center());
    QTest::mouseMove(&axial, axial.rect().center() + QPoint(20, 0));
    fixture.workspace.setActiveTool(nullptr);
    const glm::dvec3 halfWay = sliceScene(fixture, axial).centreLps;
    fixture.workspace.setActiveTool(&tool);
    QTest::mouseMove(&axial, axial.rect().center() + QPoint(40, 0));
    QVERIFY(sliceScene(fixture, axial).centreLps != halfWay);
    QTest::mouseRelease(&axial, Qt::MiddleButton, {}, axial.rect().center() + QPoint(40, 0));
    tool.heard.clear();
    // Let go over another view, which has the keys by then: here the tool draws again.
    SliceView& coronal = fixture.window.views().coronal();
    fixture.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
    axial.setFocus();
    QTest::keyPress(&axial, Qt::Key_Space);
    drag(axial, Qt::LeftButton, axial.rect().center(), {30, 0});
    coronal.setFocus();
    QTest::keyRelease(&coronal, Qt::Key_Space);
    drag(axial, Qt::LeftButton, axial.rect().center(), {30, 0});
    QVERIFY(tool.heard.contains('p'));
    // A view that one comes to while it is held hears only that it repeats.
    tool.heard.clear();
    coronal.setFocus();
    QKeyEvent repeated(QEvent::KeyPress, Qt::Key_Space, {}, QStringLiteral(" "), true);
    QApplication::sendEvent(&coronal, &repeated);
    drag(coronal, Qt::LeftButton, coronal.rect().center(), {30, 0});
    QTest::keyRelease(&coronal, Qt::Key_Space);
    QVERIFY(tool.heard.isEmpty());
    fixture.workspace.setActiveTool(nullptr);
}

/// Its cursor was for the study that was there.
void ViewsUiTest::aToolForgetsThePointerWithTheStudy()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    NotingTool tool;
    fixture.workspace.setActiveTool(&tool);
    const QPointF at(axial.width() / 2.0, axial.height() / 2.0);
    QMouseEvent move(QEvent::MouseMove, at, axial.mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(&axial, &move);
    QVERIFY(tool.isHere);
    fixture.workspace.setSession(nullptr);
    QVERIFY(!tool.isHere);
    fixture.workspace.setActiveTool(nullptr);
}

/// Another one is taken over a view, and the first one again from the tool bar.
void ViewsUiTest::aToolForgetsThePointerWithTheHand()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    NotingTool tool;
    NotingTool other;
    fixture.workspace.setActiveTool(&tool);
    test::WindowFixture::hover(axial, QPointF(axial.width(), axial.height()) / 2.0);
    QVERIFY(tool.isHere);
    fixture.workspace.setActiveTool(&other);
    QVERIFY(!tool.isHere);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&axial, &leave);
    fixture.workspace.setActiveTool(&tool);
    QVERIFY(!tool.isHere);
    fixture.workspace.setActiveTool(nullptr);
}

void ViewsUiTest::toolsDrawOverAnnotations()
{
    /// Covers all there is.
    class Painter : public NotingTool {
    public:
        void paintOverlay(QPainter& painter, const ui::ViewContext& view) const override
        {
            painter.fillRect(QRectF({}, view.sizePixels), Qt::magenta);
        }
    };
    test::WindowFixture fixture(test::headFirstSupine());
    Painter tool;
    fixture.workspace.setActiveTool(&tool);
    // Corner texts, crosshair, cube and all.
    for (ui::ImageView* view : std::initializer_list<ui::ImageView*>{
             &fixture.window.views().volume(), &fixture.window.views().axial()}) {
        // A control is pressed, not drawn on.
        for (QWidget* control : view->findChildren<QWidget*>())
            control->hide();
        const QImage shown = view->grab().toImage();
        for (int y = ui::theme::viewBarHeight; y < shown.height(); y += 2) {
            for (int x = 0; x < shown.width(); x += 2)
                QCOMPARE(shown.pixelColor(x, y), QColor(Qt::magenta));
        }
    }
    fixture.workspace.setActiveTool(nullptr);
}

void ViewsUiTest::volumeViewTurnsAndZooms()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::VolumeView& view = fixture.window.views().volume();
    const ui::Camera before = view.camera();
    drag(view, Qt::LeftButton, view.rect().center(), {50, 0});
    QVERIFY(glm::dot(before.towardsViewer, view.camera().right()) > 0.1);
    QCOMPARE(view.camera().targetLps, before.targetLps);
    drag(view, Qt::RightButton, view.rect().center(), {0, -50});
    QVERIFY(view.camera().heightMm < before.heightMm);
    drag(view, Qt::MiddleButton, view.rect().center(), {50, 0});
    QVERIFY(view.camera().targetLps != before.targetLps);
    view.resetView();
    QCOMPARE(view.camera().heightMm, before.heightMm);
    QCOMPARE(view.camera().towardsViewer, before.towardsViewer);
}

void ViewsUiTest::maximumIntensityHasItsOwnWindow()
{
    test::WindowFixture fixture(test::headFirstSupine());
    fixture.window.actionTable()[QStringLiteral("view.mip")].trigger();
    NotingTool tool;
    fixture.workspace.setActiveTool(&tool);
    const core::WindowLevel slices = fixture.workspace.windowLevel();
    const core::WindowLevel before = fixture.workspace.volumeDisplay().mipWindow;
    ui::VolumeView& view = fixture.window.views().volume();
    drag(view, Qt::RightButton, view.rect().center(), {60, 30});
    const core::WindowLevel after = fixture.workspace.volumeDisplay().mipWindow;
    QVERIFY(after.width > before.width && after.centre > before.centre);
    QCOMPARE(fixture.workspace.windowLevel(), slices);
    const auto& scene = std::get<gpu::VolumeScene>(fixture.frames.lastRequest(view.viewId()).scene);
    QCOMPARE(scene.mipWindow, after);
    fixture.workspace.setActiveTool(nullptr);
}

void ViewsUiTest::nothingIsDrawnWhileNothingChanges()
{
    test::WindowFixture fixture(test::headFirstSupine());
    QTRY_VERIFY(fixture.window.views().refined());
    const int before = fixture.frames.requestCount();
    QTest::mouseMove(&fixture.window.views().axial(), QPoint(50, 60));
    // Nothing tells that nothing comes. A view asks once more 160 ms after the last movement
    // (ImageView::m_rest); no timer of it is longer.
    QTest::qWait(250);
    QCOMPARE(fixture.frames.requestCount(), before);
}

BURIN_WINDOW_TEST(ViewsUiTest)

} // namespace viewsUiTest

#include "ViewsUiTest.moc"
