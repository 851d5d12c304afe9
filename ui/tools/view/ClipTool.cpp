// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/view/ClipTool.h"

#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/overlays/ClipOutline.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/view/HandleSizes.h"
#include "ui/workspace/ViewSteps.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>

#include <cmath>

namespace ui {

namespace {

constexpr int faceCount = 6;

} // namespace

ClipTool::ClipTool(Workspace& workspace, QObject* parent)
    : Tool(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::clipChanged, this, &Tool::overlayChanged);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_drag.reset();
        m_hovered.reset();
    });
}

QString ClipTool::name() const
{
    return tr("Clip");
}

QString ClipTool::iconName() const
{
    return QStringLiteral("clip");
}

QString ClipTool::hint() const
{
    return tr("Clip: drag a handle of box or plane; beside them the view turns");
}

QString ClipTool::keys() const
{
    return tr("Esc lets go · panel Clipping: planes, reset");
}

bool ClipTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return m_workspace.volume() && (!scene || scene->orthographic);
}

std::optional<ClipHandle> ClipTool::handleAt(const QPointF& pixel, const ViewContext& view) const
{
    std::optional<ClipHandle> nearest;
    for (const ClipHandle& handle :
        clipHandles(view, m_workspace.clip(), m_workspace.volume()->geometry)) {
        const double apart = distance(handle.pixel, pixel);
        if (apart <= (nearest ? distance(nearest->pixel, pixel) : handleGripRadius))
            nearest = handle;
    }
    return nearest;
}

bool ClipTool::takes(const PointerSample& sample, const ViewContext& view) const
{
    return handleAt(sample.position, view).has_value();
}

void ClipTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (const auto handle = handleAt(sample.position, view)) {
        m_drag = Drag{*handle, view.view, sample.position, m_workspace.clip()};
        m_workspace.viewSteps().hold();
    }
    hover(sample, view);
}

void ClipTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_drag || m_drag->view != view.view)
        return;
    m_cursor = sample.position;
    const QPointF moved = sample.position - m_drag->from;
    const QPointF way = m_drag->handle.pixelsPerMm;
    const double mm =
        QPointF::dotProduct(moved, way) / std::max(QPointF::dotProduct(way, way), 1e-9);
    m_workspace.viewSteps().change(
        movedClip(m_drag->before, m_drag->handle.face, mm, m_workspace.volume()->geometry));
    Q_EMIT overlayChanged();
}

void ClipTool::release(const PointerSample& sample, const ViewContext& view)
{
    m_drag.reset();
    m_workspace.viewSteps().release();
    hover(sample, view);
}

void ClipTool::cancel()
{
    if (!m_drag)
        return;
    m_workspace.viewSteps().cancelHold();
    m_drag.reset();
    Q_EMIT overlayChanged();
}

void ClipTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_cursor = sample.position;
    m_hovered.reset();
    if (const auto handle = handleAt(sample.position, view))
        m_hovered = handle->face;
    m_hoveredView = view.view;
    Q_EMIT overlayChanged();
}

void ClipTool::leave()
{
    m_hovered.reset();
    Q_EMIT overlayChanged();
}

QString ClipTool::textOf(int face) const
{
    const core::ClipRegion& clip = m_workspace.clip();
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    if (face >= faceCount)
        return tr("plane %1").arg(face - faceCount + 1);
    const int axis = face / 2;
    const double index = face % 2 == 1 ? clip.box.maximum[axis] : clip.box.minimum[axis];
    return tr("%1 mm").arg(numberText((index + 0.5) * geometry.spacingMm()[axis], 1));
}

void ClipTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.volume())
        return;
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    const core::ClipRegion& clip = m_workspace.clip();
    if (!view.isSlice()) {
        paintClipBox(painter, view, clip.box, geometry);
        paintClipPlanes(painter, view, clip, geometry);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    for (const ClipHandle& handle : clipHandles(view, clip, geometry)) {
        const bool held = m_drag && m_drag->view == view.view && m_drag->handle.face == handle.face;
        const bool marked =
            held || (!m_drag && m_hoveredView == view.view && m_hovered == handle.face);
        const QColor colour = handle.face < faceCount ? theme::accent : theme::caution;
        painter.setPen(QPen(QColor(0, 0, 0, 190), 1.6));
        painter.setBrush(marked ? theme::text : colour);
        painter.drawEllipse(handle.pixel, marked ? handleRadius + 1.5 : handleRadius,
            marked ? handleRadius + 1.5 : handleRadius);
        if (marked)
            drawCursorLabel(
                painter, view.sizePixels, m_cursor, handleRadius, {textOf(handle.face)});
    }
}

} // namespace ui
