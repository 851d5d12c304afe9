// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Where a slice lies in a volume, for edits that act in one slice.
struct SlicePlane {
    glm::dvec3 middleLps{0.0}; ///< the middle of the volume
    double heightMm = 0.0; ///< signed distance of the slice from that middle, along the normal
    double halfThicknessMm = 0.0; ///< half the distance between neighbouring slices
    /// A slice of the volume's grid; its number may lie outside the volume.
    struct OnGrid {
        int axis = 0; ///< index axis that leads from slice to slice
        int slice = 0; ///< index along it
    };
    std::optional<OnGrid> onGrid{}; ///< empty: the slice lies oblique to the grid
};

/// The slice through a point, perpendicular to a normal. If it lies along the grid of the volume
/// (its outermost voxels deviate by less than a quarter of a slice), it is moved to the middle of
/// the nearest slice, so that no rounding can make an edit write to a neighbouring slice.
/// @param normal a unit vector, LPS
[[nodiscard]] SlicePlane slicePlane(
    const VolumeGeometry& geometry, const glm::dvec3& normal, const glm::dvec3& throughLps);

} // namespace core
