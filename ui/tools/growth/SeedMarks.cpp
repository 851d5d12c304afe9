// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/growth/SeedMarks.h"

#include "ui/geometry/ViewContext.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>

#include <cmath>
#include <map>

namespace ui {

namespace {

/// A slice as thick as the voxels that it cuts.
class Slab {
public:
    Slab(const gpu::SliceScene& scene, const core::VolumeGeometry& geometry)
        : m_centreLps(scene.centreLps)
        , m_normal(glm::cross(scene.rightLps, scene.downLps))
    {
        const glm::dmat3 direction = geometry.direction();
        const glm::dvec3 spacing = geometry.spacingMm();
        for (int axis = 0; axis < 3; ++axis)
            m_halfMm += 0.5 * std::abs(glm::dot(m_normal, direction[axis])) * spacing[axis];
    }
    [[nodiscard]] bool holds(const glm::dvec3& lps) const
    {
        return std::abs(glm::dot(lps - m_centreLps, m_normal)) <= m_halfMm;
    }

private:
    glm::dvec3 m_centreLps;
    glm::dvec3 m_normal;
    double m_halfMm = 0.0;
};

} // namespace

std::vector<gpu::SceneSeed> seedsShownIn(const ViewContext& view, const Workspace& workspace)
{
    std::vector<gpu::SceneSeed> seeds = workspace.seeds().seeds();
    const std::vector<gpu::SceneSeed>& hollow = workspace.seeds().hollow();
    seeds.insert(seeds.end(), hollow.begin(), hollow.end());
    if (const auto* slice = std::get_if<gpu::SliceScene>(&view.scene)) {
        const Slab slab(*slice, workspace.volume()->geometry);
        std::erase_if(seeds, [&slab](const gpu::SceneSeed& seed) { return !slab.holds(seed.lps); });
    }
    return seeds;
}

void paintSeedMarks(QPainter& painter, const ViewContext& slice, const Workspace& workspace)
{
    const core::Document& document = workspace.session()->document();
    const Slab slab(std::get<gpu::SliceScene>(slice.scene), document.volumes.front().geometry);
    const auto inPlane = [&](const std::vector<gpu::SceneSeed>& seeds) {
        std::map<int, QList<QPointF>> points;
        for (const gpu::SceneSeed& seed : seeds) {
            if (slab.holds(seed.lps))
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
