// SPDX-License-Identifier: Apache-2.0
#include "core/edits/PickRays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace core {

namespace {

/// Distances along a line, in its own unit.
struct Stretch {
    double from = 0.0;
    double to = 0.0;
};

/// Where @p origin + t · @p direction lies between 0 and size − 1 along every axis.
std::optional<Stretch> insideVolume(
    const glm::dvec3& origin, const glm::dvec3& direction, const glm::ivec3& size)
{
    Stretch stretch{-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    for (int axis = 0; axis < 3; ++axis) {
        const double last = size[axis] - 1;
        if (std::abs(direction[axis]) < 1e-12) {
            if (origin[axis] < 0.0 || origin[axis] > last)
                return std::nullopt;
            continue;
        }
        const double a = -origin[axis] / direction[axis];
        const double b = (last - origin[axis]) / direction[axis];
        stretch.from = std::max(stretch.from, std::min(a, b));
        stretch.to = std::min(stretch.to, std::max(a, b));
    }
    if (stretch.from > stretch.to)
        return std::nullopt;
    return stretch;
}

glm::ivec3 fixed16(const glm::dvec3& index)
{
    return glm::ivec3(glm::round(index * 65536.0));
}

} // namespace

PickRays pickRays(const OrthographicView& view, const std::vector<glm::dvec2>& planeMm,
    const VolumeGeometry& geometry)
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
    for (const glm::dvec2& point : planeMm) {
        const glm::dvec3 world = view.targetLps + right * point.x + up * point.y;
        const glm::dvec3 origin(toIndex * glm::dvec4(world, 1.0));
        PickVoxels::Ray ray;
        if (const auto inside = insideVolume(origin, perSample, geometry.size)) {
            // On the sample grid that counts from the target's plane, so that neighbouring rays
            // step through the volume together.
            const double first = std::ceil(inside->from);
            ray.origin = fixed16(origin + perSample * first);
            ray.step = fixed16(perSample);
            ray.samples = int(std::floor(inside->to) - first) + 1;
        }
        result.rays.push_back(ray);
    }
    return result;
}

} // namespace core
