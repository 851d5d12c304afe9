// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/DrillMask.h"

#include "core/edits/ToolMasks.h"
#include "ui/tools/CursorLabel.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {

core::MaskShape drillMask(const Workspace::DrillSettings& settings, double turn)
{
    core::MaskShape mask;
    mask.kind = settings.shape;
    mask.radiusMm = settings.radiusMm;
    mask.widthMm = 2.0 * settings.radiusMm;
    mask.heightMm = std::max(mask.widthMm * settings.heightRatio, 0.1);
    mask.cornerMm = 0.25 * std::min(mask.widthMm, mask.heightMm);
    mask.rotationDegrees = std::remainder(settings.rotationDegrees + turn, 360.0);
    return mask;
}

void drawToolOutline(QPainter& painter, const QPolygonF& outline, bool closed)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 150), 3.5), QPen(toolColour(), 1.6)}) {
        painter.setPen(pen);
        if (closed)
            painter.drawPolygon(outline);
        else
            painter.drawPolyline(outline);
    }
}

void paintPatch(QPainter& painter, const SurfacePatch& surface, const ViewContext& view)
{
    QColor fill = toolColour();
    fill.setAlphaF(0.22F);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    for (const QPolygonF& square : surface.squares(view))
        painter.drawPolygon(square);
}

QPolygonF maskOutline(const core::MaskShape& mask, const QPointF& centre, double mmPerPixel)
{
    QPolygonF outline;
    for (const glm::dvec2& point : core::outlineMm(mask, mmPerPixel))
        outline << centre + QPointF(point.x, -point.y) / mmPerPixel;
    return outline;
}

} // namespace ui
