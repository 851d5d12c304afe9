// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// Take back some places of a growth and what grew through them, cut off where it is narrowest;
/// what is nearer to the seeds stays (GrowthCut.h).
struct ShrinkAt {
    std::vector<glm::dvec3> pointsLps{};
    bool onlyHere = false; ///< only the voxels at the points
    bool barrier = true; ///< the cut is shut
};

} // namespace core
