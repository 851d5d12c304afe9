// SPDX-License-Identifier: Apache-2.0
// What pointer and wheel do to the 3D view when no tool takes them.
#include "ui/menus/SegmentViews.h"
#include "ui/menus/VoxelMenu.h"
#include "ui/tools/aim/SeenVoxels.h"
#include "ui/views/VolumeView.h"

#include <QPointer>

#include <cmath>

namespace ui {

namespace {

constexpr double degreesPerPixel = 0.4;

} // namespace

ImageView::Gesture VolumeView::gestureFor(
    Qt::MouseButton button, const PointerSample&, bool toolWorksHere) const
{
    const bool grey = Workspace::greyWindow(workspace().volumeDisplay().mode) != nullptr;
    switch (button) {
    case Qt::LeftButton:
        return toolWorksHere && takesOverlays() ? Gesture::Tool : Gesture::Rotate;
    case Qt::MiddleButton:
        return Gesture::Pan;
    case Qt::RightButton:
        return workspace().activeTool() && grey ? Gesture::Window : Gesture::Zoom;
    default:
        return Gesture::None;
    }
}

void VolumeView::dragged(Gesture gesture, const QPointF& from, const QPointF& to)
{
    const QPointF moved = to - from;
    const double mmPerPixel = context().mmPerPixel();
    switch (gesture) {
    case Gesture::Rotate:
        m_camera.orbit(moved.x() * degreesPerPixel, moved.y() * degreesPerPixel);
        break;
    case Gesture::Pan:
        m_camera.pan(moved.x() * mmPerPixel, moved.y() * mmPerPixel);
        break;
    case Gesture::Zoom:
        m_camera.zoom(std::exp(moved.y() * 0.008));
        break;
    case Gesture::Window:
        return changeWindow(moved);
    case Gesture::None:
    case Gesture::Tool:
    case Gesture::Box:
    case Gesture::Turn:
    case Gesture::TurnOne:
        return; // not the 3D view's
    }
    m_fitted = m_fitted && gesture == Gesture::Rotate;
    requestMovingFrame();
}

void VolumeView::changeWindow(const QPointF& moved)
{
    const core::Volume* volume = workspace().volume();
    if (!volume)
        return;
    Workspace::VolumeDisplay display = workspace().volumeDisplay();
    if (const auto window = Workspace::greyWindow(display.mode))
        display.*window = windowAfterDrag(volume->encoding, display.*window, moved);
    workspace().setVolumeDisplay(display);
}

bool VolumeView::clicked(const QPointF& at)
{
    const auto side = cube(m_camera).sideAt(at);
    if (side)
        lookFrom(*side);
    return side.has_value();
}

void VolumeView::hovered(const PointerSample& sample)
{
    const ViewContext seen = context();
    m_readout.pointAt(std::get<gpu::VolumeScene>(seen.scene), seen.toViewPlaneMm(sample.position));
    if (workspace().activeTool())
        update();
}

bool VolumeView::canBePointedAt() const
{
    if (!workspace().session())
        return false;
    // As for the readout: rays of a perspective view differ in direction.
    if (std::get<gpu::VolumeScene>(context().scene).orthographic && takesOverlays())
        return true;
    workspace().say(tr("Side by side, nothing can be pointed at: view with one eye"));
    return false;
}

void VolumeView::askForPlace(const QPointF& at, const PlaceAnswer& then)
{
    const ViewContext seen = context();
    auto scene = std::get<gpu::VolumeScene>(seen.scene);
    // What is pointed at is a segment, wherever the volume steps back for it.
    if (scene.context != gpu::Context::Opaque)
        scene.context = gpu::Context::Hidden;
    askWhatIsSeen(workspace(), scene, {seen.toViewPlaneMm(at)},
        [self = QPointer(this), then](const core::Result<SeenVoxels>& voxels) {
            const core::Volume* volume = self ? self->workspace().volume() : nullptr;
            if (!volume)
                return;
            std::optional<glm::dvec3> place;
            if (voxels && !voxels->empty() && voxels->front())
                place = volume->geometry.toWorld(glm::dvec3(voxels->front()->voxel));
            if (!then(place))
                return;
            if (voxels)
                self->workspace().say(tr("Nothing is seen there"));
            else
                self->workspace().fail(voxels.error());
        });
}

void VolumeView::menuAsked(const QPointF& at)
{
    auto* menu = new VoxelMenu(workspace(), *this, mapToGlobal(at.toPoint()));
    menu->addAtEnd([this](QMenu& more) { addViewEntries(more); });
    if (!canBePointedAt())
        return menu->openElsewhere();
    askForPlace(at, [menu = QPointer(menu)](const std::optional<glm::dvec3>& placeLps) {
        if (!menu || menu->withdrawn())
            return false;
        if (placeLps)
            menu->openAbout(*placeLps);
        else
            menu->openElsewhere();
        return !placeLps;
    });
}

void VolumeView::activateSegmentAt(const QPointF& at)
{
    if (!canBePointedAt())
        return;
    askForPlace(at, [self = QPointer(this)](const std::optional<glm::dvec3>& placeLps) {
        if (placeLps)
            ui::activateSegmentAt(self->workspace(), *placeLps);
        return !placeLps;
    });
}

void VolumeView::leaveEvent(QEvent* event)
{
    m_readout.leave();
    ImageView::leaveEvent(event);
}

void VolumeView::wheelTurned(double steps, const QPointF& at, Qt::KeyboardModifiers)
{
    const glm::dvec3 held = context().toLps(at);
    m_camera.zoom(std::pow(1.15, -steps));
    m_camera.targetLps += held - context().toLps(at);
    m_fitted = false;
    requestMovingFrame();
}

} // namespace ui
