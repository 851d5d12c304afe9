// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/SeedMarks.h"

#include "core/session/EditSession.h"
#include "ui/tools/ViewContext.h"

#include <QPainter>

#include <cmath>
#include <map>

namespace ui {

void SeedMarks::update(const core::EditSession* session)
{
    m_marks.clear();
    if (!session)
        return;
    const core::History& history = session->history();
    for (const core::RowId id : history.standing()) {
        const core::Edit& edit = history.row(id).edit;
        if (std::holds_alternative<core::GrowSteps>(edit)) {
            m_marks.clear();
        } else if (const auto* stroke = std::get_if<core::SeedStroke>(&edit)) {
            for (const glm::dvec3& point : stroke->pointsLps)
                m_marks.push_back({point, stroke->segment});
        } else if (const auto* removed = std::get_if<core::RemoveSegment>(&edit)) {
            std::erase_if(
                m_marks, [removed](const Mark& mark) { return mark.label == removed->segment; });
        }
    }
}

void SeedMarks::paint(
    QPainter& painter, const ViewContext& view, const core::EditSession& session) const
{
    const auto* slice = std::get_if<gpu::SliceScene>(&view.scene);
    glm::dvec3 normal(0.0);
    double halfThickness = 0.0;
    if (slice) {
        normal = glm::cross(slice->rightLps, slice->downLps);
        const core::VolumeGeometry& geometry = session.document().volumes.front().geometry;
        const glm::dmat3 direction = geometry.direction();
        const glm::dvec3 spacing = geometry.spacingMm();
        for (int axis = 0; axis < 3; ++axis)
            halfThickness += 0.5 * std::abs(glm::dot(normal, direction[axis])) * spacing[axis];
    }
    std::map<int, QList<QPointF>> points;
    for (const Mark& mark : m_marks) {
        if (slice && std::abs(glm::dot(mark.lps - slice->centreLps, normal)) > halfThickness)
            continue;
        points[mark.label].push_back(view.toPixel(mark.lps));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    for (const auto& [label, dots] : points) {
        const core::Segment* segment = session.document().segment(label);
        if (!segment || !segment->visible)
            continue;
        painter.setPen(QPen(QColor(0, 0, 0, 150), 5.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawPoints(dots.data(), int(dots.size()));
        painter.setPen(QPen(QColor(segment->rgb), 3.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawPoints(dots.data(), int(dots.size()));
    }
}

} // namespace ui
