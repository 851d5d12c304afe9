// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/servers/SpaceDriver.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/SpaceSteering.h"
#include "ui/workspace/CuttingPlane.h"

#include <QApplication>
#include <QDialog>
#include <QtTest>

#include <cmath>
#include <memory>

namespace spaceSteeringUiTest {

using test::SpaceDriver;

namespace {

/// The real window, active, and a driver that it listens to.
class Bench {
public:
    Bench()
    {
        qputenv("SPNAV_SOCKET", driver.socketPath().toLocal8Bit());
        fixture = std::make_unique<test::WindowFixture>(test::headFirstSupine());
        steering = new ui::SpaceSteering(fixture->window);
        fixture->window.show();
        fixture->window.activateWindow();
        if (!driver.accept() || !QTest::qWaitForWindowActive(&fixture->window))
            qFatal("no driver, or no active window");
        view().lookFrom({0.0, -1.0, 0.0});
        // Not over the pen view, which moves the plane.
        QCursor::setPos(view().mapToGlobal(view().rect().center()));
        QObject::connect(&steering->mouse(), &ui::SpaceMouse::moved, steering, [this] { ++heard; });
    }
    ~Bench() { qunsetenv("SPNAV_SOCKET"); }

    [[nodiscard]] ui::VolumeView& view() { return fixture->window.views().volume(); }
    [[nodiscard]] ui::CuttingPlane& plane() { return fixture->workspace.plane(); }
    /// Says it, and waits until the window has heard it.
    bool move(const std::array<std::int32_t, 6>& axes)
    {
        const int before = heard;
        driver.say(SpaceDriver::motion(axes, 50));
        return QTest::qWaitFor([&] { return heard > before; });
    }
    bool press(int button, bool down)
    {
        QSignalSpy spy(&steering->mouse(), &ui::SpaceMouse::buttonChanged);
        driver.say(SpaceDriver::button(button, down));
        return spy.wait();
    }

    SpaceDriver driver;
    std::unique_ptr<test::WindowFixture> fixture;
    ui::SpaceSteering* steering = nullptr;
    int heard = 0;
};

bool near(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::length(a - b) < 1e-6;
}

} // namespace

/// The hand that does not draw moves the object in the 3D view, or the cutting plane.
class SpaceSteeringUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theObjectFollowsTheCap()
    {
        Bench bench;
        const ui::Camera before = bench.view().camera();
        // To the right and up by a twentieth of the picture's height: what was in the middle is
        // there now, so the middle lies to the left of it and below.
        QVERIFY(bench.move({350, 350, 0, 0, 0, 0}));
        const double by = 0.05 * before.heightMm;
        QVERIFY(near(bench.view().camera().targetLps,
            before.targetLps - by * before.right() - by * before.up));
        QCOMPARE(bench.view().camera().heightMm, before.heightMm);
        QVERIFY(!bench.view().fitted());
    }

    void pullingMakesItLarger()
    {
        Bench bench;
        const double before = bench.view().camera().heightMm;
        QVERIFY(bench.move({0, 0, -350, 0, 0, 0}));
        QVERIFY(std::abs(bench.view().camera().heightMm - before * std::exp(-0.05)) < 1e-6);
        QVERIFY(bench.move({0, 0, 350, 0, 0, 0}));
        QVERIFY(std::abs(bench.view().camera().heightMm - before) < 1e-6);
    }

    void itTurnsAboutAnyAxis()
    {
        Bench bench;
        const ui::Camera before = bench.view().camera();
        // Twisting the cap counter-clockwise, as the user sees it from above: its front goes to
        // the right, and what was at the user's left comes to the front.
        QVERIFY(bench.move({0, 0, 0, 0, 350, 0}));
        const double angle = glm::radians(6.0);
        QVERIFY(near(bench.view().camera().towardsViewer,
            before.towardsViewer * std::cos(angle) - before.right() * std::sin(angle)));
        QVERIFY(bench.view().fitted()); // it is whole still
        // Back, then rolled about the line of sight: upright no more.
        QVERIFY(bench.move({0, 0, 0, 0, -350, 0}));
        QVERIFY(near(bench.view().camera().towardsViewer, before.towardsViewer));
        QVERIFY(bench.move({0, 0, 0, 0, 0, -350}));
        QVERIFY(near(bench.view().camera().towardsViewer, before.towardsViewer));
        QVERIFY(near(bench.view().camera().up,
            before.up * std::cos(angle) + before.right() * std::sin(angle)));
    }

    void theFirstButtonHoldsThePlane()
    {
        Bench bench;
        const ui::Camera camera = bench.view().camera();
        const ui::CuttingPlane::Pose before = bench.plane().pose();
        QVERIFY(!bench.plane().look().shown);
        QVERIFY(bench.press(0, true));
        QVERIFY(bench.plane().look().shown);
        QVERIFY(bench.move({350, 0, 350, 0, 0, 0}));
        const double by = 0.05 * camera.heightMm;
        QVERIFY(near(bench.plane().pose().centreLps,
            before.centreLps + by * camera.right() - by * camera.towardsViewer));
        QVERIFY(near(bench.plane().pose().rightLps, before.rightLps));
        QVERIFY(bench.move({0, 0, 0, 0, 0, 350}));
        // About the line of sight, away from the viewer by the right-hand rule.
        const double angle = glm::radians(6.0);
        const glm::dvec3 axis = -camera.towardsViewer;
        const glm::dvec3 normal = before.normalLps();
        QVERIFY(near(bench.plane().pose().normalLps(),
            normal * std::cos(angle) + glm::cross(axis, normal) * std::sin(angle)
                + axis * (glm::dot(axis, normal) * (1.0 - std::cos(angle)))));
        QVERIFY(near(bench.view().camera().targetLps, camera.targetLps));
        QVERIFY(near(bench.view().camera().up, camera.up));

        QVERIFY(bench.press(0, false));
        const ui::CuttingPlane::Pose left = bench.plane().pose();
        QVERIFY(bench.move({350, 0, 0, 0, 0, 0}));
        QVERIFY(near(bench.plane().pose().centreLps, left.centreLps));
        QVERIFY(!near(bench.view().camera().targetLps, camera.targetLps));
    }

    void theSecondButtonShowsTheWhole()
    {
        Bench bench;
        QVERIFY(bench.move({350, 0, -350, 0, 0, 0}));
        QVERIFY(!bench.view().fitted());
        QVERIFY(bench.press(1, true));
        QVERIFY(bench.view().fitted());
    }

    /// Over the pen view the plane follows the cap along its own axes.
    void overThePenViewThePlaneFollows()
    {
        Bench bench;
        bench.fixture->window.views().arrange(ui::ViewGrid::Layout::PenAndStage);
        ui::PlaneView& pen = bench.fixture->window.views().plane();
        QTRY_VERIFY(pen.isVisible());
        QCursor::setPos(pen.mapToGlobal(pen.rect().center()));
        QTRY_VERIFY(pen.underMouse());
        const ui::Camera camera = bench.view().camera();
        const double by = 0.05 * camera.heightMm;
        ui::CuttingPlane::Pose before = bench.plane().pose();
        QVERIFY(bench.move({350, 0, 0, 0, 0, 0}));
        QVERIFY(near(bench.plane().pose().centreLps, before.centreLps + by * before.rightLps));
        before = bench.plane().pose();
        QVERIFY(bench.move({0, 350, 0, 0, 0, 0}));
        QVERIFY(near(bench.plane().pose().centreLps, before.centreLps - by * before.downLps));
        before = bench.plane().pose();
        QVERIFY(bench.move({0, 0, 350, 0, 0, 0}));
        QVERIFY(near(bench.plane().pose().centreLps, before.centreLps + by * before.normalLps()));
        QVERIFY(near(bench.view().camera().targetLps, camera.targetLps));

        // A drag belongs to the picture that it was begun in: the 3D view moves instead.
        before = bench.plane().pose();
        const QPoint middle = pen.rect().center();
        QTest::mousePress(&pen, Qt::MiddleButton, {}, middle);
        const QPointF to = QPointF(middle) + QPointF(0.0, 30.0);
        QMouseEvent drag(
            QEvent::MouseMove, to, pen.mapToGlobal(to), Qt::NoButton, Qt::MiddleButton, {});
        QApplication::sendEvent(&pen, &drag);
        QVERIFY(pen.pointerIsAtWork());
        before = bench.plane().pose();
        QVERIFY(bench.move({350, 0, 0, 0, 0, 0}));
        QVERIFY(near(bench.plane().pose().centreLps, before.centreLps));
        QVERIFY(!near(bench.view().camera().targetLps, camera.targetLps));
        QTest::mouseRelease(&pen, Qt::MiddleButton, {}, to.toPoint());
    }

    void aButtonIsNotHeldByADriverThatHasGone()
    {
        Bench bench;
        QVERIFY(bench.press(0, true));
        QSignalSpy gone(&bench.steering->mouse(), &ui::SpaceMouse::disconnected);
        bench.driver.hangUp();
        QVERIFY(gone.wait());
        QVERIFY(bench.steering->mouse().connectTo(bench.driver.socketPath()));
        QVERIFY(bench.driver.accept());
        const ui::CuttingPlane::Pose before = bench.plane().pose();
        const ui::Camera camera = bench.view().camera();
        QVERIFY(bench.move({350, 0, 0, 0, 0, 0}));
        QVERIFY(near(bench.plane().pose().centreLps, before.centreLps));
        QVERIFY(!near(bench.view().camera().targetLps, camera.targetLps));
    }

    void aDialogIsNotWorkedBehind()
    {
        Bench bench;
        const ui::Camera before = bench.view().camera();
        QDialog dialog(&bench.fixture->window);
        dialog.setModal(true);
        dialog.show();
        dialog.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        QVERIFY(bench.move({350, 0, 0, 350, 0, 0}));
        QVERIFY(near(bench.view().camera().targetLps, before.targetLps));
        QVERIFY(near(bench.view().camera().towardsViewer, before.towardsViewer));
        QVERIFY(bench.press(0, true));
        QVERIFY(!bench.plane().look().shown);
    }
};

BURIN_WINDOW_TEST(SpaceSteeringUiTest)

} // namespace spaceSteeringUiTest

#include "SpaceSteeringUiTest.moc"
