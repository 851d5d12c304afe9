// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/ReferenceLines.h"

#include "core/volume/ClipRegion.h"
#include "ui/overlays/PlaneOutline.h"

#include <QPainter>
#include <QPainterPath>

#include <cmath>

namespace ui {

namespace {

constexpr double gapPixels = 14.0; ///< as that of the crosshair

} // namespace

std::optional<std::pair<glm::dvec3, glm::dvec3>> referenceLine(
    const ViewContext& view, const ReferencePlane& plane, const core::VolumeGeometry& geometry)
{
    const auto& slice = std::get<gpu::SliceScene>(view.scene);
    const glm::dvec3 normal = glm::cross(slice.rightLps, slice.downLps);
    // Nearly the same plane: a line would jump about.
    if (std::abs(glm::dot(normal, plane.normalLps)) > 0.9999)
        return std::nullopt;
    return lineAcross(view,
        core::boxSection(
            core::wholeVolume(geometry).box, geometry, plane.pointLps, plane.normalLps));
}

void paintReferenceLines(QPainter& painter, const ViewContext& view,
    std::span<const ReferencePlane> planes, const core::VolumeGeometry& geometry,
    const QPointF& gapAt)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath outside;
    outside.addRect(QRectF(QPointF(0.0, 0.0), view.sizePixels));
    outside.addEllipse(gapAt, gapPixels, gapPixels); // the odd-even rule leaves it out
    painter.setClipPath(outside, Qt::IntersectClip);
    for (const ReferencePlane& plane : planes) {
        const auto line = referenceLine(view, plane, geometry);
        if (!line)
            continue;
        const QPointF from = view.toPixel(line->first);
        const QPointF to = view.toPixel(line->second);
        for (const QPen& pen : {QPen(QColor(0, 0, 0, 110), 2.4), QPen(plane.colour, 1.0)}) {
            painter.setPen(pen);
            painter.drawLine(from, to);
        }
    }
    painter.restore();
}

} // namespace ui
