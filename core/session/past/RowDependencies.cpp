// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/RowDependencies.h"

#include "core/edits/EditRows.h"
#include "core/sculpt/radiation/Radiation.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// The point of a segment that lies nearest.
glm::dvec2 nearestOn(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& point)
{
    const glm::dvec2 along = to - from;
    const double squared = glm::dot(along, along);
    const double t =
        squared > 0.0 ? std::clamp(glm::dot(point - from, along) / squared, 0.0, 1.0) : 0.0;
    return from + t * along;
}

bool isCovered(const dependsOn::Bricks& bricks, const BrickKey& key)
{
    return bricks.keys.count(key) != 0;
}

bool isCovered(const dependsOn::Plane& plane, const BrickKey& key)
{
    return key.field != Field::Coverage && (!plane.plane || key.plane == *plane.plane);
}

bool isCovered(const dependsOn::AllPlanes& planes, const BrickKey& key)
{
    const bool isAsked = key.field == Field::Labels || key.field == Field::SeedWords;
    return (isAsked && planes.bricks.count(key.brick) != 0) || planes.written.count(key) != 0;
}

bool isCovered(const dependsOn::SeedWords& growth, const BrickKey& key)
{
    const bool isAsked = key.field == Field::Coverage ? growth.coverage : key.plane == growth.plane;
    const bool isOfMembers = key.field == Field::SeedWords || key.field == Field::Overwritten;
    return isAsked && (isOfMembers || growth.beside.count(key.brick) != 0);
}

bool isCovered(const dependsOn::Fields& fields, const BrickKey& key)
{
    return key.field == Field::Coverage ? fields.layers[key.plane] : fields.plane == key.plane;
}

bool isCovered(const dependsOn::SweptToolMask& mask, const BrickKey& key)
{
    const bool isRead =
        key.field == Field::Coverage || (key.field == Field::Labels && mask.labels[key.plane]);
    if (!isRead || mask.path.empty())
        return false;
    // Radiation at a position is interpolated between the voxels around it, and theirs depends on
    // coverage no farther than radiation::reach.
    constexpr double halfSide = BrickGrid::side / 2.0 + radiation::reach + 1.0;
    const glm::dvec3 middle = glm::dvec3(mask.grid.brickPosition(int(key.brick)) * BrickGrid::side)
        + (BrickGrid::side - 1) / 2.0;
    const glm::dvec3 place = mask.origin + mask.perVoxel * middle;
    double nearestMm = place.z;
    for (int axis = 0; axis < 3; ++axis)
        nearestMm -= halfSide * std::abs(mask.perVoxel[axis].z);
    if (nearestMm > mask.endMm)
        return false;
    // A brick, seen along the view, is convex, and so is each piece of the path: where they keep
    // apart along the line between their nearest points, they keep apart.
    for (std::size_t i = 0; i < mask.path.size(); ++i) {
        const glm::dvec2 nearest = nearestOn(
            mask.path[i], mask.path[std::min(i + 1, mask.path.size() - 1)], glm::dvec2(place));
        const glm::dvec2 away = glm::dvec2(place) - nearest;
        const double distance = glm::length(away);
        double halfWidth = 0.0;
        for (int axis = 0; axis < 3 && distance > 0.0; ++axis)
            halfWidth +=
                halfSide * std::abs(glm::dot(glm::dvec2(mask.perVoxel[axis]), away)) / distance;
        if (distance - halfWidth <= mask.reachMm)
            return true;
    }
    return false;
}

} // namespace

RowDependencies::RowDependencies(const Edit& edit, const Document& document,
    const std::vector<BrickKey>& written, const RowTrace& trace)
    : m_dependencies(
        dependenciesOf(edit, {.document = document, .written = written, .trace = trace}))
{
}

bool RowDependencies::covers(const BrickKey& key) const
{
    if (key.field == Field::Labels && m_dependencies.labelPlanes.test(key.plane))
        return true;
    const dependsOn::Any& any = m_dependencies;
    return std::visit(
        [&key](const auto& dependencies) { return isCovered(dependencies, key); }, any);
}

} // namespace core
