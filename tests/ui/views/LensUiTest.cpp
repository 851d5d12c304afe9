// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/views/Lens.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTest>

#include <cmath>
#include <vector>

namespace lensUiTest {

using ui::Lens;
using ui::SliceView;

namespace {

constexpr double tiny = 1e-9;

/// With the pictures that were requested last.
QImage seen(ui::ImageView& view)
{
    QCoreApplication::processEvents();
    return view.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

void hover(QWidget& view, const QPointF& at)
{
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(&view, &move);
}

const gpu::FrameRequest& lensOf(const test::WindowFixture& fixture, const SliceView& view)
{
    return fixture.frames.lastRequest(Lens::nameOver(view.viewId()));
}

/// Whether a picture shows a place of the patient at a pixel.
bool showsThere(const QImage& image, const QPointF& at, const glm::dvec3& lps)
{
    const QRgb shown = image.pixel(at.toPoint());
    const glm::ivec3 expected = test::FakeFrames::colourAt(lps);
    return std::abs(qRed(shown) - expected.x) <= 1 && std::abs(qGreen(shown) - expected.y) <= 1
        && std::abs(qBlue(shown) - expected.z) <= 1;
}

/// Away from the crosshair's lines and from the middle of everything.
QPointF placeIn(const QWidget& view)
{
    return QPointF(std::round(0.38 * view.width()), std::round(0.44 * view.height()));
}

} // namespace

class LensUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void showsWhatLiesUnderThePointer();
    void enlargesThePictureUntilItsOwnComes();
    void followsPointerAndSlices();
    void goesWithItsKey();
    void movesNoTool();
};

void LensUiTest::showsWhatLiesUnderThePointer()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    const QPointF at = placeIn(axial);
    hover(axial, at);
    const QImage before = seen(axial);
    QTest::keyPress(&axial, Qt::Key_Z);
    QVERIFY(axial.showsLens());
    const QImage image = seen(axial);
    const ui::ViewContext view = axial.context();
    const QPointF half(0.5, 0.5); // the middle of a pixel
    for (const QPointF& away :
        {QPointF(60.0, 30.0), QPointF(-50.0, 40.0), QPointF(20.0, -70.0), QPointF(-30.0, -60.0)}) {
        const glm::dvec3 place = view.toLps(at + (away + half) / Lens::magnification);
        QVERIFY(showsThere(image, at + away, place));
        // It is not what the slice has there.
        QVERIFY(!showsThere(image, at + away, view.toLps(at + away + half)));
    }
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const bool beside =
                std::hypot(x - at.x(), y - at.y()) > 0.5 * Lens::diameterPixels + 5.0;
            QVERIFY(!beside || image.pixel(x, y) == before.pixel(x, y));
        }
    }
    QTest::keyRelease(&axial, Qt::Key_Z);
    QVERIFY(!axial.showsLens());
    QCOMPARE(seen(axial), before);
}

void LensUiTest::enlargesThePictureUntilItsOwnComes()
{
    test::NoFrames frames;
    Lens lens(frames, 1);
    QImage whole(256, 256, QImage::Format_RGB32);
    for (int y = 0; y < whole.height(); ++y)
        for (int x = 0; x < whole.width(); ++x)
            whole.setPixel(x, y, qRgb(x, y, 0));
    const QSizeF size(256.0, 256.0);
    const QPointF at(120.0, 110.0);
    lens.lookAt(at, {1, gpu::SliceScene(), size}, {}, 1.0);
    QImage image(256, 256, QImage::Format_RGB32);
    image.fill(Qt::blue);
    QPainter painter(&image);
    lens.paint(painter, whole, size);
    painter.end();
    const QRgb seenThere = image.pixel(120 + 60, 110 - 45);
    QVERIFY(std::abs(qRed(seenThere) - (120 + 20)) <= 1);
    QVERIFY(std::abs(qGreen(seenThere) - (110 - 15)) <= 1);
    QCOMPARE(image.pixel(5, 5), qRgb(0, 0, 255));

    // Put away it paints nothing.
    lens.putAway();
    image.fill(Qt::blue);
    painter.begin(&image);
    lens.paint(painter, whole, size);
    painter.end();
    QCOMPARE(image.pixel(120 + 60, 110 - 45), qRgb(0, 0, 255));
}

void LensUiTest::followsPointerAndSlices()
{
    test::WindowFixture fixture(test::oblique());
    SliceView& axial = fixture.window.views().axial();
    const auto agrees = [&](const QPointF& at) {
        const ui::ViewContext view = axial.context();
        const auto& slice = std::get<gpu::SliceScene>(view.scene);
        const gpu::FrameRequest& request = lensOf(fixture, axial);
        auto scene = std::get<gpu::SliceScene>(request.scene);
        const double ratio = axial.devicePixelRatioF();
        const bool placed = glm::distance(scene.centreLps, view.toLps(at)) < tiny
            && std::abs(scene.mmPerPixel * ratio * Lens::magnification - slice.mmPerPixel) < tiny
            && request.sizePixels == glm::ivec2(int(std::lround(Lens::diameterPixels * ratio)));
        // In all else it is the slice.
        scene.centreLps = slice.centreLps;
        scene.mmPerPixel = slice.mmPerPixel;
        return placed && scene == slice;
    };
    QPointF at = placeIn(axial);
    hover(axial, at);
    QTest::keyPress(&axial, Qt::Key_Z);
    QVERIFY(agrees(at));
    at += QPointF(17.0, -9.0);
    hover(axial, at);
    QVERIFY(agrees(at));

    const int number = axial.sliceNumber();
    QTest::keyClick(&axial, Qt::Key_Up);
    QCOMPARE(axial.sliceNumber(), number + 1);
    QVERIFY(agrees(at));
    fixture.workspace.setWindowLevel({111.0, 222.0});
    QVERIFY(agrees(at));
    axial.setTurn({true, 1});
    QVERIFY(agrees(at));
    ui::Workspace::ViewOptions options = fixture.workspace.viewOptions();
    options.colours = gpu::ColourMap::HotIron;
    fixture.workspace.setViewOptions(options);
    QVERIFY(agrees(at));
    QTest::keyRelease(&axial, Qt::Key_Z);
}

void LensUiTest::goesWithItsKey()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    const QPointF at = placeIn(axial);
    hover(axial, at);
    QVERIFY(!axial.showsLens());
    const auto hold = [&axial, at] {
        hover(axial, at);
        QTest::keyPress(&axial, Qt::Key_Z);
        return axial.showsLens();
    };
    QVERIFY(hold());
    // Held down it repeats itself.
    QKeyEvent repeated(QEvent::KeyRelease, Qt::Key_Z, {}, QStringLiteral("z"), true);
    QApplication::sendEvent(&axial, &repeated);
    QVERIFY(axial.showsLens());
    QTest::keyRelease(&axial, Qt::Key_Z);
    QVERIFY(!axial.showsLens());
    // Where the key is let go is not told to who lost the keyboard, or the pointer.
    QVERIFY(hold());
    QFocusEvent out(QEvent::FocusOut);
    QApplication::sendEvent(&axial, &out);
    QVERIFY(!axial.showsLens());
    QVERIFY(hold());
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&axial, &leave);
    QVERIFY(!axial.showsLens());
    hover(axial, at);
    QVERIFY(!axial.showsLens());
    // Undo is another key.
    QKeyEvent undo(QEvent::KeyPress, Qt::Key_Z, Qt::ControlModifier);
    QApplication::sendEvent(&axial, &undo);
    QVERIFY(!axial.showsLens());
    // Nothing is open: nothing to look at.
    QVERIFY(hold());
    fixture.workspace.setSession(nullptr);
    QVERIFY(!axial.showsLens());
}

void LensUiTest::movesNoTool()
{
    test::WindowFixture fixture(test::smallHead::volume());
    core::EditSession& session = *fixture.workspace.session();
    const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
    SliceView& axial = fixture.window.views().axial();
    const glm::ivec3 middle(glm::round(geometry.toIndex(fixture.workspace.crosshairLps())));
    // A click leads the crosshair to what is under the pointer.
    const QPointF clicked = placeIn(axial);
    const glm::dvec3 meant = axial.context().toLps(clicked);
    hover(axial, clicked);
    QTest::keyPress(&axial, Qt::Key_Z);
    QTest::mouseClick(&axial, Qt::LeftButton, {}, clicked.toPoint());
    QVERIFY(axial.showsLens());
    QVERIFY(glm::distance(fixture.workspace.crosshairLps(), meant) < tiny);
    QTest::keyRelease(&axial, Qt::Key_Z);

    ui::PaintTool paint(fixture.workspace);
    fixture.workspace.setBrushSettings(
        ui::Workspace::Brush::Paint, {.radiusMm = 1.2, .disc = true});
    fixture.workspace.setActiveTool(&paint);
    const glm::ivec3 voxel = middle + glm::ivec3(9, -6, 0);
    const QPointF at = axial.context().toPixel(geometry.toWorld(glm::dvec3(voxel)));
    test::Pen pen(axial);
    pen.hover(at, 1000);
    QTest::keyPress(&axial, Qt::Key_Z);
    QVERIFY(axial.showsLens());
    pen.press(at, 0.5, 1010);
    pen.release(at, 1020);
    QVERIFY(axial.showsLens());
    QTest::keyRelease(&axial, Qt::Key_Z);
    session.poll();
    QVERIFY(session.settle());
    int label = -1;
    session.questions().probe(
        {voxel}, [&](const core::Result<std::vector<core::ProbedVoxel>>& probes) {
            label = int(probes->front().label);
        });
    for (int round = 0; round < 5 && label < 0; ++round) {
        QVERIFY(session.settle());
        session.poll();
    }
    QVERIFY(label > 0);
    fixture.workspace.setActiveTool(nullptr);
}

BURIN_WINDOW_TEST(LensUiTest)

} // namespace lensUiTest

#include "LensUiTest.moc"
