// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/tools/view/MeasureTool.h"
#include "ui/views/ViewGrid.h"

#include <QtTest>

#include <cmath>
#include <stdexcept>

namespace stereoUiTest {

namespace {

constexpr gpu::ViewId rightEye = 1002; // of the view whose name is 2

ui::Stereo stereo(ui::Stereo::Mode mode, double degrees = 4.0)
{
    return {.mode = mode, .eyesDegrees = degrees, .swapped = false};
}

const gpu::VolumeScene& sceneOf(const test::FakeFrames& frames, gpu::ViewId view)
{
    return std::get<gpu::VolumeScene>(frames.lastRequest(view).scene);
}

QImage filled(const QColor& colour)
{
    QImage image(8, 4, QImage::Format_RGBX8888);
    image.fill(colour);
    return image;
}

} // namespace

/// What both eyes see, in one view.
class StereoUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void twoPicturesBecomeOne()
    {
        const QImage left = filled(QColor(200, 10, 20));
        const QImage right = filled(QColor(30, 140, 150));
        const QImage red = ui::composed(ui::Stereo::Mode::Anaglyph, left, right);
        QCOMPARE(red.size(), left.size());
        QCOMPARE(red.pixelColor(3, 2), QColor(200, 140, 150));
        const QImage beside = ui::composed(ui::Stereo::Mode::SideBySide, left, right);
        QCOMPARE(beside.size(), left.size());
        QCOMPARE(beside.pixelColor(1, 1), QColor(200, 10, 20));
        QCOMPARE(beside.pixelColor(6, 1), QColor(30, 140, 150));
        QVERIFY(ui::composed(ui::Stereo::Mode::Off, left, right) == left);
        // While a view changes its size the other eye lags behind.
        QVERIFY(ui::composed(ui::Stereo::Mode::Anaglyph, left, right.copy(0, 0, 4, 4)) == left);
    }

    void bothEyesAreAskedFor()
    {
        test::WindowFixture fixture(test::smallHead::volume());
        ui::VolumeView& view = fixture.window.views().volume();
        QVERIFY_THROWS_EXCEPTION(std::out_of_range, sceneOf(fixture.frames, rightEye));
        view.setStereo(stereo(ui::Stereo::Mode::Anaglyph));
        const gpu::VolumeScene left = sceneOf(fixture.frames, view.viewId());
        gpu::VolumeScene right = sceneOf(fixture.frames, rightEye);
        QVERIFY(left.eyeShiftMm < 0.0);
        const double awayMm = glm::distance(left.eyeLps, left.targetLps);
        QVERIFY(std::abs(glm::degrees(2.0 * std::atan(-left.eyeShiftMm / awayMm)) - 4.0) < 1e-9);
        QCOMPARE(right.eyeShiftMm, -left.eyeShiftMm);
        right.eyeShiftMm = left.eyeShiftMm;
        QVERIFY(right == left);
        // They go together.
        view.turn(20.0, 0.0);
        QVERIFY(sceneOf(fixture.frames, rightEye).eyeLps != right.eyeLps);
        QVERIFY(sceneOf(fixture.frames, rightEye).eyeLps
            == sceneOf(fixture.frames, view.viewId()).eyeLps);
        ui::Stereo swapped = view.stereo();
        swapped.swapped = true;
        view.setStereo(swapped);
        QVERIFY(sceneOf(fixture.frames, view.viewId()).eyeShiftMm > 0.0);

        // Nobody looks: nothing is drawn for the other eye either.
        fixture.window.views().maximise(&fixture.window.views().axial());
        QVERIFY_THROWS_EXCEPTION(std::out_of_range, sceneOf(fixture.frames, rightEye));
        fixture.window.views().maximise(nullptr);
        QTRY_VERIFY(view.isVisible());
        QCOMPARE(sceneOf(fixture.frames, rightEye).eyeShiftMm,
            -sceneOf(fixture.frames, view.viewId()).eyeShiftMm);
        view.setStereo(stereo(ui::Stereo::Mode::Off));
        QVERIFY_THROWS_EXCEPTION(std::out_of_range, sceneOf(fixture.frames, rightEye));
        QCOMPARE(sceneOf(fixture.frames, view.viewId()).eyeShiftMm, 0.0);
    }

    void sideBySideTheViewTurnsUnderAnyTool()
    {
        test::WindowFixture fixture(test::smallHead::volume());
        ui::VolumeView& view = fixture.window.views().volume();
        ui::MeasureTool tool(fixture.workspace);
        fixture.workspace.setActiveTool(&tool);
        const auto drag = [&] {
            test::Pen pen(view);
            const QPointF middle = view.rect().toRectF().center();
            pen.press(middle, 1.0, 1000);
            for (int i = 1; i <= 8; ++i)
                pen.move(middle + QPointF(6.0 * i, 0.0), 1.0, quint64(1000 + 10 * i));
            pen.release(middle + QPointF(48.0, 0.0), 1100);
        };
        const glm::dvec3 from = view.camera().towardsViewer;
        view.setStereo(stereo(ui::Stereo::Mode::Anaglyph));
        drag();
        QVERIFY(view.camera().towardsViewer == from);
        view.setStereo(stereo(ui::Stereo::Mode::SideBySide));
        drag();
        QVERIFY(view.camera().towardsViewer != from);
        // The picture is there all the same.
        QTRY_VERIFY(view.quality() == gpu::Frame::Quality::Refined);
        const QImage shown = view.grab().toImage();
        const int y = shown.height() / 2;
        QCOMPARE(
            shown.pixelColor(shown.width() / 4, y), shown.pixelColor(shown.width() * 3 / 4, y));
    }

    void keysTurnTheStage()
    {
        test::WindowFixture fixture(test::smallHead::volume());
        ui::VolumeView& view = fixture.window.views().volume();
        fixture.window.views().axial().setFocus();
        const glm::dvec3 from = view.camera().towardsViewer;
        fixture.window.actionTable()[QStringLiteral("view.turnRight")].trigger();
        QVERIFY(view.camera().towardsViewer != from);
        fixture.window.actionTable()[QStringLiteral("view.turnLeft")].trigger();
        QVERIFY(glm::distance(view.camera().towardsViewer, from) < 1e-9);
        QVERIFY(!fixture.window.actionTable()[QStringLiteral("view.eyesApart")].isEnabled());
        fixture.window.actionTable()[QStringLiteral("view.anaglyph")].trigger();
        QCOMPARE(view.stereo().mode, ui::Stereo::Mode::Anaglyph);
        const double before = view.stereo().eyesDegrees;
        fixture.window.actionTable()[QStringLiteral("view.eyesApart")].trigger();
        QCOMPARE(view.stereo().eyesDegrees, before + 0.5);
    }
};

BURIN_WINDOW_TEST(StereoUiTest)

} // namespace stereoUiTest

#include "StereoUiTest.moc"
