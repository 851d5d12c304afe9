// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Where a slice lies in a volume, for edits that act in one slice.
struct SlicePlane {
    glm::dvec3 middleLps{0.0}; ///< of the volume
    double heightMm = 0.0; ///< of the slice over that middle, along the normal
    double halfThicknessMm = 0.0; ///< half the distance of neighbouring slices
    /// A slice along the grid, which may lie beside the volume.
    struct OnGrid {
        int axis = 0; ///< the one that leads from slice to slice
        int slice = 0; ///< index along it
    };
    std::optional<OnGrid> onGrid{}; ///< none: it lies oblique to the voxels
};

/// The slice across a normal through a point. One that lies along the grid of the volume is brought
/// to the middle of the nearest slice, so that no rounding can make an edit write a neighbour.
/// @param normal a unit vector
[[nodiscard]] SlicePlane slicePlane(
    const VolumeGeometry& geometry, const glm::dvec3& normal, const glm::dvec3& throughLps);

} // namespace core
