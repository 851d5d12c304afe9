// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gpu {

/// Where a tool's own coordinates run through a volume, mm16.
struct PlaneAxes {
    glm::ivec3 origin{0}; ///< of voxel (0, 0, 0)
    glm::ivec3 perI{0};
    glm::ivec3 perJ{0};
    glm::ivec3 perK{0};
};

/// A box in these coordinates, mm16.
struct PlaneBox {
    glm::ivec3 minimum{0};
    glm::ivec3 maximum{0};
};

/// Bricks with voxels in any of the boxes, ascending; some too many, since kernels decide.
[[nodiscard]] std::vector<std::uint32_t> bricksUnder(
    const PlaneAxes& axes, const core::BrickGrid& grid, const std::vector<PlaneBox>& boxes);

} // namespace gpu
