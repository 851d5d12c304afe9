// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/SlicePlane.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

double snappedHeight(const VolumeGeometry& geometry, const glm::dvec3& normal,
    const glm::dvec3& middleLps, const glm::dvec3& throughLps)
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
        glm::dvec3 slice = (glm::dvec3(geometry.size) - 1.0) / 2.0;
        slice[axis] = std::floor(geometry.toIndex(throughLps)[axis] + 0.5);
        return glm::dot(normal, geometry.toWorld(slice) - middleLps);
    }
    return glm::dot(normal, throughLps - middleLps);
}

} // namespace

SlicePlane slicePlane(
    const VolumeGeometry& geometry, const glm::dvec3& normal, const glm::dvec3& throughLps)
{
    SlicePlane plane;
    plane.middleLps = geometry.toWorld((glm::dvec3(geometry.size) - 1.0) / 2.0);
    plane.heightMm = snappedHeight(geometry, normal, plane.middleLps, throughLps);
    for (int axis = 0; axis < 3; ++axis) {
        const double step = std::abs(glm::dot(normal, glm::dvec3(geometry.indexToWorld[axis])));
        plane.halfThicknessMm = std::max(plane.halfThicknessMm, step / 2.0);
    }
    return plane;
}

} // namespace core
