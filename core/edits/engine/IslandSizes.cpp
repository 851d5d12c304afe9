// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/IslandSizes.h"

#include "core/volume/VolumeGeometry.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

constexpr double slackVoxels = 1e-6;

double voxelsIn(double mm3, const VolumeGeometry& geometry)
{
    constexpr double most = 1e15; // more than any volume has, and fits an integer
    const glm::dvec3 spacing = geometry.spacingMm();
    return std::min(most, mm3 / (spacing.x * spacing.y * spacing.z));
}

} // namespace

std::int64_t fewestVoxels(double mm3, const VolumeGeometry& geometry)
{
    return std::int64_t(std::ceil(voxelsIn(mm3, geometry) - slackVoxels));
}

std::int64_t mostVoxels(double mm3, const VolumeGeometry& geometry)
{
    return std::int64_t(std::floor(voxelsIn(mm3, geometry) + slackVoxels));
}

} // namespace core
