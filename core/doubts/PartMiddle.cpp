// SPDX-License-Identifier: Apache-2.0
#include "core/doubts/PartMiddle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

namespace {

template <class Visit>
void forEachVoxel(const VoxelRuns& voxels, const glm::ivec3& size, const Visit& visit)
{
    for (const VoxelRun& run : voxels.runs()) {
        for (std::uint64_t number = run.first; number < run.first + run.count; ++number)
            visit(voxelOf(number, size));
    }
}

} // namespace

glm::i64vec3 spacingUm(const VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    glm::i64vec3 um(1);
    for (int axis = 0; axis < 3; ++axis)
        um[axis] = std::max<std::int64_t>(1, std::llround(spacing[axis] * 1000.0));
    return um;
}

glm::ivec3 voxelOf(std::uint64_t number, const glm::ivec3& size)
{
    const auto columns = std::uint64_t(size.x);
    const auto rows = std::uint64_t(size.y);
    return {int(number % columns), int(number / columns % rows), int(number / columns / rows)};
}

glm::ivec3 middleOf(const VoxelRuns& voxels, const VolumeGeometry& geometry)
{
    glm::i64vec3 sum(0);
    forEachVoxel(voxels, geometry.size, [&](const glm::ivec3& at) { sum += glm::i64vec3(at); });
    const glm::i64vec3 centre = sum / std::int64_t(voxels.voxelCount());
    const glm::i64vec3 side = spacingUm(geometry);
    glm::ivec3 middle(0);
    std::int64_t nearest = std::numeric_limits<std::int64_t>::max();
    forEachVoxel(voxels, geometry.size, [&](const glm::ivec3& at) {
        const glm::i64vec3 off = (glm::i64vec3(at) - centre) * side;
        const std::int64_t squared = off.x * off.x + off.y * off.y + off.z * off.z;
        if (squared < nearest) {
            nearest = squared;
            middle = at;
        }
    });
    return middle;
}

} // namespace core
