// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/PlaneOutline.h"

#include "ui/base/Theme.h"
#include "ui/workspace/CuttingPlane.h"

#include <QPainter>

#include <cmath>
#include <vector>

namespace ui {

std::optional<std::pair<glm::dvec3, glm::dvec3>> lineAcross(
    const ViewContext& view, const std::vector<glm::dvec3>& section)
{
    const auto& slice = std::get<gpu::SliceScene>(view.scene);
    const glm::dvec3 normal = glm::cross(slice.rightLps, slice.downLps);
    std::vector<glm::dvec3> ends;
    for (std::size_t i = 0; i < section.size(); ++i) {
        const glm::dvec3& from = section[i];
        const glm::dvec3& to = section[(i + 1) % section.size()];
        const double before = glm::dot(from - slice.centreLps, normal);
        const double after = glm::dot(to - slice.centreLps, normal);
        if ((before < 0.0) != (after < 0.0))
            ends.push_back(from + (to - from) * (before / (before - after)));
    }
    if (ends.size() != 2)
        return std::nullopt;
    return std::pair(ends[0], ends[1]);
}

std::optional<std::pair<glm::dvec3, glm::dvec3>> planeLine(
    const ViewContext& view, const CuttingPlane& plane)
{
    const auto& slice = std::get<gpu::SliceScene>(view.scene);
    const glm::dvec3 normal = glm::cross(slice.rightLps, slice.downLps);
    // Nearly the same plane: a line would jump about.
    if (!plane.look().shown || std::abs(glm::dot(normal, plane.pose().normalLps())) > 0.9999)
        return std::nullopt;
    return lineAcross(view, plane.section());
}

void paintPlaneLine(QPainter& painter, const ViewContext& view, const CuttingPlane& plane)
{
    const auto line = planeLine(view, plane);
    if (!line)
        return;
    const auto& slice = std::get<gpu::SliceScene>(view.scene);
    const QPointF from = view.toPixel(line->first);
    const QPointF to = view.toPixel(line->second);
    const glm::dvec3 above = -plane.pose().normalLps();
    QPointF tick(glm::dot(above, slice.rightLps), glm::dot(above, slice.downLps));
    tick *= 6.0 / std::max(std::hypot(tick.x(), tick.y()), 1e-6);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 120), 2.8), QPen(theme::plane, 1.2)}) {
        painter.setPen(pen);
        painter.drawLine(from, to);
        for (const double along : {0.1, 0.5, 0.9}) {
            const QPointF at = from + (to - from) * along;
            painter.drawLine(at, at + tick);
        }
    }
    painter.restore();
}

} // namespace ui
