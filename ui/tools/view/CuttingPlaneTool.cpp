// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/view/CuttingPlaneTool.h"

#include "ui/base/Theme.h"
#include "ui/tools/aim/SeenVoxels.h"
#include "ui/tools/view/HandleSizes.h"
#include "ui/tools/view/PlaneOptions.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>
#include <QPointer>

#include <cmath>

namespace ui {

namespace {

constexpr double degreesPerPixel = 0.4;

} // namespace

CuttingPlaneTool::CuttingPlaneTool(Workspace& workspace, QObject* parent)
    : Tool(parent)
    , m_workspace(workspace)
{
    connect(&workspace.plane(), &CuttingPlane::changed, this, &Tool::overlayChanged);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_drag.reset();
        m_hovered.reset();
        setAim(Aim::Handles);
    });
    // Who takes it wants to see what it moves.
    connect(&workspace, &Workspace::activeToolChanged, this, [this] {
        if (m_workspace.activeTool() == this)
            m_workspace.plane().show();
        else
            setAim(Aim::Handles);
    });
}

void CuttingPlaneTool::setAim(Aim aim)
{
    m_points.clear();
    if (aim == m_aim)
        return;
    m_aim = aim;
    Q_EMIT aimChanged();
    Q_EMIT overlayChanged();
}

QString CuttingPlaneTool::name() const
{
    return tr("Plane");
}

QString CuttingPlaneTool::iconName() const
{
    return QStringLiteral("plane");
}

QString CuttingPlaneTool::hint() const
{
    return tr("Plane: drag its handles, or in the pen view itself; elsewhere the view turns");
}

QString CuttingPlaneTool::target() const
{
    switch (m_aim) {
    case Aim::ThreePoints:
        return tr("point %1 of 3").arg(m_points.size() + 1);
    case Aim::Across:
        return tr("click on a vessel or a surface");
    case Aim::Handles:
        break;
    }
    return tr("puts the cutting plane");
}

QString CuttingPlaneTool::keys() const
{
    return tr("Ctrl turns within the plane · Esc lets go");
}

QWidget* CuttingPlaneTool::createOptions(QWidget* parent)
{
    return new PlaneOptions(m_workspace, *this, parent);
}

bool CuttingPlaneTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return m_workspace.volume() && (!scene || scene->orthographic);
}

std::optional<PlaneHandle> CuttingPlaneTool::handleAt(
    const QPointF& pixel, const ViewContext& view) const
{
    std::optional<PlaneHandle> nearest;
    for (const PlaneHandle& handle : planeHandles(view, m_workspace.plane())) {
        const double apart = distance(handle.pixel, pixel);
        if (apart <= (nearest ? distance(nearest->pixel, pixel) : handleGripRadius))
            nearest = handle;
    }
    return nearest;
}

bool CuttingPlaneTool::takes(const PointerSample& sample, const ViewContext& view) const
{
    return m_aim != Aim::Handles || showsPlaneItself(view, m_workspace.plane())
        || handleAt(sample.position, view).has_value();
}

void CuttingPlaneTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (m_aim != Aim::Handles)
        return point(sample.position, view);
    CuttingPlane& plane = m_workspace.plane();
    const std::optional<PlaneHandle> handle = handleAt(sample.position, view);
    if (handle || showsPlaneItself(view, plane))
        m_drag = Drag{
            .handle = handle, .view = view.view, .last = sample.position, .before = plane.pose()};
    hover(sample, view);
}

void CuttingPlaneTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_drag || m_drag->view != view.view)
        return;
    if (!m_drag->handle) {
        turnInPenView(sample, view);
    } else {
        // Step by step, so that a handle that turns goes round with the pointer.
        for (const PlaneHandle& handle : planeHandles(view, m_workspace.plane())) {
            if (handle.id == m_drag->handle->id)
                m_drag->handle = handle;
        }
        dragPlane(m_workspace.plane(), *m_drag->handle, m_drag->last, sample.position);
    }
    m_drag->last = sample.position;
    Q_EMIT overlayChanged();
}

void CuttingPlaneTool::turnInPenView(const PointerSample& sample, const ViewContext& view)
{
    CuttingPlane& plane = m_workspace.plane();
    const QPointF moved = sample.position - m_drag->last;
    const auto& slice = std::get<gpu::SliceScene>(view.scene);
    // The view may be flipped and turned by quarters: its axes, of those of the plane.
    const auto ofPose = [&plane](const glm::dvec3& direction) {
        return glm::round(glm::dvec2(
            glm::dot(direction, plane.pose().rightLps), glm::dot(direction, plane.pose().downLps)));
    };
    const auto axisOf = [&plane](const glm::dvec2& shares) {
        return shares.x * plane.pose().rightLps + shares.y * plane.pose().downLps;
    };
    const glm::dvec2 right = ofPose(slice.rightLps);
    const glm::dvec2 down = ofPose(slice.downLps);
    if (!(sample.modifiers & Qt::ControlModifier)) {
        // What is seen goes with the pointer, as in the 3D view.
        plane.turn(axisOf(down), moved.x() * degreesPerPixel);
        plane.turn(axisOf(right), -moved.y() * degreesPerPixel);
        return;
    }
    const QPointF middle(view.sizePixels.width() / 2, view.sizePixels.height() / 2);
    const double fromFront = right.x * down.y - right.y * down.x; // −1: the view is mirrored
    plane.turn(plane.pose().normalLps(),
        -fromFront * glm::degrees(turnAround(middle, m_drag->last, sample.position)));
}

void CuttingPlaneTool::release(const PointerSample& sample, const ViewContext& view)
{
    m_drag.reset();
    hover(sample, view);
}

void CuttingPlaneTool::cancel()
{
    if (m_drag)
        m_workspace.plane().setPose(m_drag->before);
    m_drag.reset();
    setAim(Aim::Handles);
    Q_EMIT overlayChanged();
}

void CuttingPlaneTool::point(const QPointF& pixel, const ViewContext& view)
{
    if (view.isSlice())
        return take(view.toLps(pixel));
    askWhatIsPointedAt(m_workspace, std::get<gpu::VolumeScene>(view.scene),
        {view.toViewPlaneMm(pixel)}, [self = QPointer(this)](const core::Result<SeenVoxels>& seen) {
            if (!self || !self->m_workspace.volume())
                return;
            if (!seen)
                return self->m_workspace.fail(seen.error());
            if (seen->empty() || !seen->front())
                return self->m_workspace.say(tr("Nothing is seen there"));
            self->take(
                self->m_workspace.volume()->geometry.toWorld(glm::dvec3(seen->front()->voxel)));
        });
}

void CuttingPlaneTool::take(const glm::dvec3& placeLps)
{
    CuttingPlane& plane = m_workspace.plane();
    if (m_aim == Aim::Across) {
        plane.askAcross(placeLps);
        setAim(Aim::Handles);
    } else if (m_aim == Aim::ThreePoints) {
        m_points.push_back(placeLps);
        if (m_points.size() < 3)
            return Q_EMIT overlayChanged();
        if (!plane.passThrough(m_points[0], m_points[1], m_points[2]))
            m_workspace.say(tr("Three points on a line have no plane: choose others"));
        setAim(Aim::Handles);
    }
}

void CuttingPlaneTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_hovered.reset();
    if (m_aim == Aim::Handles) {
        if (const auto handle = handleAt(sample.position, view))
            m_hovered = handle->id;
    }
    m_hoveredView = view.view;
    Q_EMIT overlayChanged();
}

void CuttingPlaneTool::leave()
{
    m_hovered.reset();
    Q_EMIT overlayChanged();
}

void CuttingPlaneTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.volume())
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(0, 0, 0, 190), 1.6));
    for (const glm::dvec3& point : m_points) {
        painter.setBrush(theme::caution);
        painter.drawEllipse(view.toPixel(point), 4.0, 4.0);
    }
    if (m_aim != Aim::Handles)
        return;
    for (const PlaneHandle& handle : planeHandles(view, m_workspace.plane())) {
        const bool held = m_drag && m_drag->handle && m_drag->view == view.view
            && m_drag->handle->id == handle.id;
        const bool marked =
            held || (!m_drag && m_hoveredView == view.view && m_hovered == handle.id);
        const double radius = marked ? handleRadius + 1.5 : handleRadius;
        painter.setBrush(marked ? theme::text : theme::plane);
        // Round ones turn it, the square one moves it.
        if (handle.turns)
            painter.drawEllipse(handle.pixel, radius, radius);
        else
            painter.drawRoundedRect(
                QRectF(handle.pixel - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius)), 2.0,
                2.0);
    }
}

} // namespace ui
