// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/HalfSpaces.h"

#include "core/edits/kinds/parts/ClipHalfSpaces.h"

#include <algorithm>
#include <cmath>

namespace core {

ClipHalfSpaces clipHalfSpaces(const ClipRegion& region, const VolumeGeometry& geometry)
{
    std::vector<ClipHalfSpace> sides;
    const glm::dmat3 worldToIndex(geometry.worldToIndex());
    for (const HalfSpace& half : halfSpaces(region, geometry)) {
        // dot(n, index) ≤ offset, in millimetres.
        const glm::dvec3 normal = glm::transpose(worldToIndex) * half.normal;
        const double length = glm::length(normal);
        sides.push_back(
            {normal / length, (half.offset + glm::dot(normal, geometry.originLps())) / length});
    }
    if (sides.empty())
        return std::nullopt;
    return sides;
}

std::vector<IntegerHalfSpace> integerHalfSpaces(
    const ClipHalfSpaces& hidden, const VolumeGeometry& geometry)
{
    constexpr double perVoxel = 1048576.0;
    constexpr double farthest = 1099511627776.0;
    std::vector<IntegerHalfSpace> halves;
    if (!hidden)
        return halves;
    const glm::dmat3 indexToWorld(geometry.indexToWorld);
    for (const ClipHalfSpace& side : *hidden) {
        const glm::dvec3 normal = glm::transpose(indexToWorld) * side.normalLps;
        const glm::dvec3 size = glm::abs(normal);
        const double scale = perVoxel / std::max({size.x, size.y, size.z});
        const double offset =
            (side.offsetMm - glm::dot(side.normalLps, geometry.originLps())) * scale;
        halves.push_back(
            {glm::ivec3(int(std::llround(normal.x * scale)), int(std::llround(normal.y * scale)),
                 int(std::llround(normal.z * scale))),
                std::llround(std::clamp(offset, -farthest, farthest))});
    }
    return halves;
}

} // namespace core
