// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gpu {

/// How the coordinates of a tool (its mask plane and depth) run through a volume: their value at
/// voxel (0, 0, 0), and what is added per voxel along each axis. In 1/65536 mm.
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

/// Bricks that may have voxels in any of the boxes, ascending. Some of them have none; kernels
/// decide for each voxel.
[[nodiscard]] std::vector<std::uint32_t> bricksUnder(
    const PlaneAxes& axes, const core::BrickGrid& grid, const std::vector<PlaneBox>& boxes);

} // namespace gpu
