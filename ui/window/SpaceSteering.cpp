// SPDX-License-Identifier: Apache-2.0
#include "ui/window/SpaceSteering.h"

#include "ui/views/ViewGrid.h"
#include "ui/window/MainWindow.h"
#include "ui/workspace/CuttingPlane.h"

#include <QApplication>
#include <QEvent>

#include <cmath>

namespace ui {

namespace {

constexpr int planeButton = 0;
constexpr int wholeButton = 1;
/// In a second at full deflection.
constexpr double heightsPushed = 1.0;
constexpr double degreesTurned = 120.0;

} // namespace

SpaceSteering::SpaceSteering(MainWindow& window)
    : QObject(&window)
    , m_window(window)
{
    connect(&m_mouse, &SpaceMouse::moved, this, &SpaceSteering::follow);
    connect(&m_mouse, &SpaceMouse::buttonChanged, this, &SpaceSteering::pressed);
    connect(&m_mouse, &SpaceMouse::disconnected, this, [this] { m_holdsPlane = false; });
    window.installEventFilter(this);
    m_mouse.connectTo();
}

bool SpaceSteering::eventFilter(QObject* watched, QEvent* event)
{
    // The driver may have been started since.
    if (event->type() == QEvent::WindowActivate)
        m_mouse.connectTo();
    return QObject::eventFilter(watched, event);
}

bool SpaceSteering::isInCharge() const
{
    return m_window.workspace().volume() && QApplication::activeWindow()
        && !QApplication::activeModalWidget();
}

void SpaceSteering::pressed(int button, bool down)
{
    if (button == planeButton)
        m_holdsPlane = down && isInCharge();
    if (!down || !isInCharge())
        return;
    VolumeView& view = m_window.views().volume();
    if (button == planeButton)
        m_window.workspace().plane().show();
    else if (button == wholeButton && !view.pointerIsAtWork())
        view.resetView();
}

void SpaceSteering::follow(const SpaceMotion& motion)
{
    if (!isInCharge())
        return;
    // A stroke belongs to the picture that it was begun in; the other view can be moved meanwhile.
    const PlaneView& plane = m_window.views().plane();
    const bool planeRests = !plane.pointerIsAtWork();
    if (m_holdsPlane || (plane.underMouse() && planeRests)) {
        if (planeRests)
            followPlane(motion);
    } else if (!m_window.views().volume().pointerIsAtWork()) {
        followObject(motion);
    }
}

void SpaceSteering::followPlane(const SpaceMotion& motion)
{
    CuttingPlane& plane = m_window.workspace().plane();
    const Camera& camera = m_window.views().volume().camera();
    CuttingPlane::Pose pose = plane.pose();
    // The user's axes in the view that the plane is moved in.
    const glm::dmat3 axes = m_holdsPlane
        ? glm::dmat3(camera.right(), camera.up, camera.towardsViewer)
        : glm::dmat3(pose.rightLps, -pose.downLps, -pose.normalLps());
    pose.centreLps += axes * motion.push * (heightsPushed * camera.heightMm);
    plane.setPose(pose);
    if (const double turned = glm::length(motion.turn); turned > 0.0)
        plane.turn(axes * (motion.turn / turned), turned * degreesTurned);
}

void SpaceSteering::followObject(const SpaceMotion& motion)
{
    VolumeView& view = m_window.views().volume();
    Camera camera = view.camera();
    camera.turn(motion.turn * degreesTurned);
    camera.pan(motion.push.x * heightsPushed * camera.heightMm,
        -motion.push.y * heightsPushed * camera.heightMm);
    camera.zoom(std::exp(-motion.push.z));
    view.moveCamera(camera);
}

} // namespace ui
