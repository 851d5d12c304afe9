// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Actions.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

#include <cmath>

namespace linkedPlacesUiTest {

using ui::SliceView;

namespace {

constexpr double tiny = 1e-9;

void pan(QWidget& view, const QPoint& by)
{
    const QPoint from = view.rect().center();
    QTest::mousePress(&view, Qt::MiddleButton, {}, from);
    const QPointF at(from + by);
    QMouseEvent move(
        QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::MiddleButton, {});
    QApplication::sendEvent(&view, &move);
    QTest::mouseRelease(&view, Qt::MiddleButton, {}, from + by);
}

void zoom(QWidget& view, int steps, const QPointF& at)
{
    QWheelEvent event(at, view.mapToGlobal(at), QPoint(), QPoint(0, 120 * steps), Qt::NoButton,
        Qt::ControlModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
}

const gpu::SliceScene& sceneOf(const test::WindowFixture& fixture, const SliceView& view)
{
    return std::get<gpu::SliceScene>(fixture.frames.lastRequest(view.viewId()).scene);
}

} // namespace

class LinkedPlacesUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void viewsAreOnTheirOwnAtFirst();
    void theOthersFollow();
    void whatWasSetIsNotLed();
};

void LinkedPlacesUiTest::viewsAreOnTheirOwnAtFirst()
{
    test::WindowFixture fixture(test::headFirstSupine());
    SliceView& axial = fixture.window.views().axial();
    const gpu::SliceScene before = sceneOf(fixture, fixture.window.views().coronal());
    pan(axial, {40, -20});
    zoom(axial, 2, axial.rect().center());
    const gpu::SliceScene after = sceneOf(fixture, fixture.window.views().coronal());
    QCOMPARE(after.mmPerPixel, before.mmPerPixel);
    QVERIFY(after.centreLps == before.centreLps);
    QVERIFY(!fixture.window.views().coronal().place().has_value());
}

void LinkedPlacesUiTest::theOthersFollow()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::ViewGrid& grid = fixture.window.views();
    SliceView& axial = grid.axial();
    const glm::dvec3 crosshair = fixture.workspace.crosshairLps();
    const gpu::SliceScene coronalBefore = sceneOf(fixture, grid.coronal());
    QAction& action = fixture.window.actionTable()[QStringLiteral("view.linkedPlaces")];
    action.trigger();
    QVERIFY(action.isChecked());

    pan(axial, {40, -20});
    const gpu::SliceScene panned = sceneOf(fixture, axial);
    // Along what both have, the same place; along what it alone has, its own; and the slices that
    // were shown are shown on.
    const gpu::SliceScene coronal = sceneOf(fixture, grid.coronal());
    const gpu::SliceScene sagittal = sceneOf(fixture, grid.sagittal());
    QVERIFY(std::abs(coronal.centreLps.x - panned.centreLps.x) < tiny);
    QVERIFY(std::abs(coronal.centreLps.z - coronalBefore.centreLps.z) < tiny);
    QVERIFY(std::abs(coronal.centreLps.y - crosshair.y) < tiny);
    QVERIFY(std::abs(sagittal.centreLps.y - panned.centreLps.y) < tiny);
    QVERIFY(std::abs(sagittal.centreLps.x - crosshair.x) < tiny);
    QVERIFY(std::abs(panned.centreLps.x - crosshair.x) > 1.0);

    // Zoomed about a place beside the middle, which stays under the pointer.
    const QPointF at(axial.width() * 0.75, axial.height() * 0.25);
    const glm::dvec3 held = axial.context().toLps(at);
    zoom(axial, 3, at);
    QVERIFY(glm::length(axial.context().toLps(at) - held) < tiny);
    const gpu::SliceScene zoomed = sceneOf(fixture, axial);
    QVERIFY(zoomed.mmPerPixel < panned.mmPerPixel);
    for (const SliceView* view : grid.slices())
        QCOMPARE(view->place()->mmPerPixel, zoomed.mmPerPixel);
    QVERIFY(std::abs(sceneOf(fixture, grid.coronal()).centreLps.x - zoomed.centreLps.x) < tiny);
    QVERIFY(fixture.workspace.crosshairLps() == crosshair);

    // Another one leads.
    pan(grid.coronal(), {0, 25});
    const gpu::SliceScene led = sceneOf(fixture, grid.coronal());
    QVERIFY(std::abs(sceneOf(fixture, grid.sagittal()).centreLps.z - led.centreLps.z) < tiny);
    QVERIFY(std::abs(sceneOf(fixture, axial).centreLps.y - zoomed.centreLps.y) < tiny);

    // One grey scale, as always.
    const core::WindowLevel window{123.0, 456.0};
    fixture.workspace.setWindowLevel(window);
    for (const SliceView* view : {&grid.axial(), &grid.sagittal(), &grid.coronal()})
        QCOMPARE(sceneOf(fixture, *view).window, window);
}

void LinkedPlacesUiTest::whatWasSetIsNotLed()
{
    test::WindowFixture fixture(test::headFirstSupine());
    ui::ViewGrid& grid = fixture.window.views();
    fixture.window.actionTable()[QStringLiteral("view.linkedPlaces")].trigger();
    // A session that is opened sets each view's place by itself.
    grid.axial().setPlace({.centreLps = {1.0, 2.0, 3.0}, .mmPerPixel = 0.5});
    grid.coronal().setPlace({.centreLps = {4.0, 5.0, 6.0}, .mmPerPixel = 0.25});
    QCOMPARE(grid.axial().place()->mmPerPixel, 0.5);
    QCOMPARE(grid.coronal().place()->mmPerPixel, 0.25);
    QVERIFY(!grid.sagittal().place().has_value());
}

BURIN_WINDOW_TEST(LinkedPlacesUiTest)

} // namespace linkedPlacesUiTest

#include "LinkedPlacesUiTest.moc"
