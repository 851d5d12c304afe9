// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/SlicePlane.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

std::optional<SlicePlane::OnGrid> sliceOnGrid(
    const VolumeGeometry& geometry, const glm::dvec3& normal, const glm::dvec3& throughLps)
{
    for (int axis = 0; axis < 3; ++axis) {
        const auto stepAlong = [&](int each) {
            return glm::dot(normal, glm::dvec3(geometry.indexToWorld[each]));
        };
        double tilt = 0.0; // how far the outermost voxels of a slice leave its middle's plane
        for (int other = 0; other < 3; ++other) {
            if (other != axis)
                tilt += std::abs(stepAlong(other)) * geometry.size[other] / 2.0;
        }
        if (tilt >= 0.25 * std::abs(stepAlong(axis)))
            continue;
        // Farther outside than any volume reaches the cast to an integer would not be defined.
        constexpr double farthest = 1e6;
        const double slice = std::floor(geometry.toIndex(throughLps)[axis] + 0.5);
        return SlicePlane::OnGrid{
            .axis = axis, .slice = int(std::fmax(-farthest, std::fmin(slice, farthest)))};
    }
    return std::nullopt;
}

} // namespace

SlicePlane slicePlane(
    const VolumeGeometry& geometry, const glm::dvec3& normal, const glm::dvec3& throughLps)
{
    SlicePlane plane;
    const glm::dvec3 middle = (glm::dvec3(geometry.size) - 1.0) / 2.0;
    plane.middleLps = geometry.toWorld(middle);
    plane.onGrid = sliceOnGrid(geometry, normal, throughLps);
    glm::dvec3 heldLps = throughLps;
    if (plane.onGrid) {
        glm::dvec3 middleOfSlice = middle;
        middleOfSlice[plane.onGrid->axis] = plane.onGrid->slice;
        heldLps = geometry.toWorld(middleOfSlice);
    }
    plane.heightMm = glm::dot(normal, heldLps - plane.middleLps);
    for (int axis = 0; axis < 3; ++axis) {
        const double step = std::abs(glm::dot(normal, glm::dvec3(geometry.indexToWorld[axis])));
        plane.halfThicknessMm = std::max(plane.halfThicknessMm, step / 2.0);
    }
    return plane;
}

} // namespace core
