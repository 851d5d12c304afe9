// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/PickRays.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

namespace {

/// Half a voxel beyond the outermost centres along every axis: where the volume's border is.
std::vector<HalfSpace> withinBorder(const glm::ivec3& size)
{
    ClipRegion border;
    border.box = {glm::dvec3(-0.5), glm::dvec3(size) - 0.5, true};
    return halfSpaces(border, {});
}

glm::ivec3 toFixed16(const glm::dvec3& index)
{
    return glm::ivec3(glm::round(index * 65536.0));
}

} // namespace

PickRays pickRays(const OrthographicView& view, const std::vector<glm::dvec2>& planeMm,
    const VolumeGeometry& geometry, const ClipRegion& clip)
{
    const glm::dvec3 forward = glm::normalize(view.targetLps - view.eyeLps);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, view.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const glm::dvec3 spacing = geometry.spacingMm();

    PickRays result;
    result.sampleMm = 0.5 * std::min({spacing.x, spacing.y, spacing.z});
    const glm::dmat4 toIndex = geometry.worldToIndex();
    const glm::dvec3 perSample(toIndex * glm::dvec4(forward * result.sampleMm, 0.0));
    result.rays.reserve(planeMm.size());
    std::vector<HalfSpace> seen = withinBorder(geometry.size);
    const std::vector<HalfSpace> unclipped = halfSpaces(clip, geometry);
    seen.insert(seen.end(), unclipped.begin(), unclipped.end());
    const LineStretch everywhere{
        -std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    for (const glm::dvec2& point : planeMm) {
        const glm::dvec3 world = view.targetLps + right * point.x + up * point.y;
        const glm::dvec3 origin(toIndex * glm::dvec4(world, 1.0));
        PickRay ray;
        if (const auto inside = stretchInside(everywhere, origin, perSample, seen)) {
            // On the sample grid that counts from the target's plane, so that neighbouring rays
            // step through the volume together.
            const double first = std::ceil(inside->from);
            ray.origin = toFixed16(origin + perSample * first);
            ray.step = toFixed16(perSample);
            ray.samples = std::max(int(std::floor(inside->to) - first) + 1, 0);
        }
        result.rays.push_back(ray);
    }
    return result;
}

} // namespace core
