// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/StrokeSpace.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// The voxel of a brush that is nearest to a place in stroke coordinates; it may lie outside the
/// volume. Of a flat brush, the one of its slab in the nearest column along the axis that the plane
/// is steepest to.
glm::ivec3 brushVoxel(const BrushPath& path, const StrokeSpace& space,
    const VolumeGeometry& geometry, const glm::dvec3& place)
{
    glm::dvec3 index = geometry.toIndex(space.toLps(place));
    if (isFlat(path.shape)) {
        glm::dvec3 rise; // over the plane, from voxel to voxel
        for (int axis = 0; axis < 3; ++axis)
            rise[axis] = (space.toStroke * glm::dvec3(geometry.indexToWorld[axis])).z;
        int main = 0;
        for (int axis = 1; axis < 3; ++axis) {
            if (std::abs(rise[axis]) > std::abs(rise[main]))
                main = axis;
        }
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == main)
                continue;
            const double nearest = std::floor(index[axis] + 0.5);
            index[main] -= rise[axis] * (nearest - index[axis]) / rise[main];
            index[axis] = nearest;
        }
    }
    // A place far off is as good as one that is just outside.
    const glm::dvec3 last(geometry.size);
    return glm::ivec3(glm::floor(glm::clamp(index, glm::dvec3(-1.0), last) + 0.5));
}

} // namespace

std::vector<glm::ivec3> voxelsUnder(const BrushPath& path, const VolumeGeometry& geometry,
    const glm::dvec3* from, const std::vector<glm::dvec3>& points)
{
    const StrokeSpace space = strokeSpace(path, geometry);
    const double stepMm = 0.5 * finestSpacing(geometry);
    const auto inPlane = [&](const glm::dvec3& point) {
        const glm::dvec3 at = space.turned(point);
        return isFlat(path.shape) ? glm::dvec3(at.x, at.y, 0.0) : at;
    };
    std::vector<glm::ivec3> under;
    for (const glm::dvec3& point : points) {
        const glm::dvec3 end = inPlane(point);
        const glm::dvec3 start = from ? inPlane(*from) : end;
        const glm::dvec3 along = end - start;
        const auto steps =
            std::max<std::int64_t>(1, std::int64_t(std::ceil(glm::length(along) / stepMm)));
        const auto [first, last] = piecesNear(start, along, steps, space.volumeRadiusMm + stepMm);
        for (std::int64_t step = first; first < last && step <= last; ++step) {
            const glm::ivec3 voxel =
                brushVoxel(path, space, geometry, start + along * (double(step) / double(steps)));
            const bool inside = glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0)))
                && glm::all(glm::lessThan(voxel, geometry.size));
            if (inside && (under.empty() || under.back() != voxel))
                under.push_back(voxel);
        }
        from = &point;
    }
    return under;
}

std::vector<glm::ivec3> voxelsUnder(const BrushPath& path, const VolumeGeometry& geometry)
{
    std::vector<glm::ivec3> under;
    for (std::size_t i = 0; i < path.pointsLps.size(); ++i) {
        const bool anew = i == 0
            || std::find(path.lifts.begin(), path.lifts.end(), std::int64_t(i)) != path.lifts.end();
        const std::vector<glm::ivec3> part = voxelsUnder(
            path, geometry, anew ? nullptr : &path.pointsLps[i - 1], {path.pointsLps[i]});
        under.insert(under.end(), part.begin(), part.end());
    }
    return under;
}

glm::ivec3 startVoxel(const BrushPath& path, const VolumeGeometry& geometry)
{
    const StrokeSpace space = strokeSpace(path, geometry);
    const glm::dvec3 at = space.turned(path.pointsLps.front());
    const glm::ivec3 voxel =
        brushVoxel(path, space, geometry, isFlat(path.shape) ? glm::dvec3(at.x, at.y, 0.0) : at);
    return glm::clamp(voxel, glm::ivec3(0), geometry.size - 1);
}

} // namespace core
