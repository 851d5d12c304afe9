// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/scissors/EditablePart.h"

#include "core/edits/engine/BoxVoxels.h"

#include <QPolygonF>

#include <algorithm>
#include <vector>

namespace ui {

namespace {

/// What voxels cover in a view, along its direction: the convex hull of their corners.
QPolygonF shadowOf(
    const core::VoxelSpan& voxels, const core::VolumeGeometry& geometry, const ViewContext& view)
{
    std::vector<QPointF> corners;
    for (int corner = 0; corner < 8; ++corner) {
        glm::dvec3 index = glm::dvec3(voxels.from) - 0.5;
        for (int axis = 0; axis < 3; ++axis) {
            if (corner & (1 << axis))
                index[axis] = voxels.to[axis] + 0.5;
        }
        corners.push_back(view.toPixel(geometry.toWorld(index)));
    }
    std::sort(corners.begin(), corners.end(), [](const QPointF& one, const QPointF& other) {
        return one.x() != other.x() ? one.x() < other.x() : one.y() < other.y();
    });
    // The monotone chain: one side of the hull forth, the other one back.
    QPolygonF hull;
    for (const bool back : {false, true}) {
        const qsizetype start = hull.size();
        for (const QPointF& corner : corners) {
            const auto turnsAway = [&hull, &corner] {
                const QPointF last = hull.last() - hull[hull.size() - 2];
                const QPointF next = corner - hull.last();
                return last.x() * next.y() - last.y() * next.x() <= 0.0;
            };
            while (hull.size() >= start + 2 && turnsAway())
                hull.removeLast();
            hull.append(corner);
        }
        hull.removeLast();
        if (!back)
            std::reverse(corners.begin(), corners.end());
    }
    return hull;
}

} // namespace

QPainterPath editablePart(const core::EditableRange& range, const QPainterPath& path,
    const core::VolumeGeometry& geometry, const ViewContext& view)
{
    if (range.inside && range.inside->empty())
        return {};
    if (!range.box)
        return path;
    const auto voxels = core::voxelsOf(*range.box, geometry, QStringLiteral("editable.box"));
    if (!voxels)
        return {};
    QPainterPath shadow;
    shadow.addPolygon(shadowOf(*voxels, geometry, view));
    shadow.closeSubpath();
    return path.intersected(shadow);
}

} // namespace ui
