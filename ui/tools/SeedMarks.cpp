// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/SeedMarks.h"

#include "ui/PendingSeeds.h"
#include "ui/Workspace.h"
#include "ui/tools/ViewContext.h"

#include <QPainter>

#include <cmath>
#include <map>

namespace ui {

void paintSeedMarks(QPainter& painter, const ViewContext& slice, const Workspace& workspace)
{
    const auto& scene = std::get<gpu::SliceScene>(slice.scene);
    const core::Document& document = workspace.session()->document();
    const glm::dvec3 normal = glm::cross(scene.rightLps, scene.downLps);
    const core::VolumeGeometry& geometry = document.volumes.front().geometry;
    const glm::dmat3 direction = geometry.direction();
    const glm::dvec3 spacing = geometry.spacingMm();
    double halfThickness = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        halfThickness += 0.5 * std::abs(glm::dot(normal, direction[axis])) * spacing[axis];

    const auto inPlane = [&](const std::vector<gpu::SceneSeed>& seeds) {
        std::map<int, QList<QPointF>> points;
        for (const gpu::SceneSeed& seed : seeds) {
            if (std::abs(glm::dot(seed.lps - scene.centreLps, normal)) <= halfThickness)
                points[seed.label].push_back(slice.toPixel(seed.lps));
        }
        return points;
    };
    const auto points = inPlane(workspace.seeds().seeds());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const auto& [label, rings] : inPlane(workspace.seeds().hollow())) {
        const core::Segment* segment = document.segment(label);
        for (const QPen& pen : {QPen(QColor(0, 0, 0, 150), 3.0),
                 QPen(QColor(segment ? segment->rgb : 0xFFFFFF), 1.4)}) {
            painter.setPen(pen);
            for (const QPointF& ring : rings)
                painter.drawEllipse(ring, 3.0, 3.0);
        }
    }
    for (const auto& [label, dots] : points) {
        const core::Segment* segment = document.segment(label);
        if (!segment)
            continue;
        painter.setPen(QPen(QColor(0, 0, 0, 150), 5.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawPoints(dots.data(), int(dots.size()));
        painter.setPen(QPen(QColor(segment->rgb), 3.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawPoints(dots.data(), int(dots.size()));
    }
}

} // namespace ui
