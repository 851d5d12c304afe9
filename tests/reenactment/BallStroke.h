// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reenactment/UserEye.h"

namespace reenact {

/// A ball that is led along a way: what a brush paints or erases, and about what a sphere pushes.
struct BallStroke {
    double radius = 0.0; ///< voxels
    std::vector<glm::dvec3> points; ///< index
    int axis = 0; ///< across which the slice lies on which it is led
    /// Voxels that are right afterwards and were not, less those spoilt, by an unsteady hand.
    int gain = 0;
};

/// The stroke that mends most of a region: of all radii, of ways in the three planes through its
/// best place. The same for the brush and for the sphere.
/// @param leastRadius voxels @param isDisc of that slice alone, which then passes through voxels
[[nodiscard]] BallStroke bestStroke(
    const UserEye& eye, const UserEye::Region& region, double leastRadius, bool isDisc = false);

} // namespace reenact
