// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

#include <compare>
#include <cstdint>

namespace core {

/// Names one voxel of a volume by its brick and its place there; ordered by brick, then by offset.
/// One number of 32 bits is not enough: a volume may have more than 2³² voxels.
struct BrickVoxel {
    std::uint32_t brick = 0;
    std::uint32_t offset = 0; ///< in the brick, 0 … 4095

    auto operator<=>(const BrickVoxel&) const = default;

    [[nodiscard]] static BrickVoxel of(const BrickGrid& grid, const glm::ivec3& voxel)
    {
        return {.brick = std::uint32_t(grid.brickOf(voxel)),
            .offset = std::uint32_t(BrickGrid::offsetInBrick(voxel))};
    }
    /// Where it lies, in index space.
    [[nodiscard]] glm::ivec3 place(const BrickGrid& grid) const
    {
        return grid.brickPosition(int(brick)) * BrickGrid::side
            + glm::ivec3(int(offset & 15u), int(offset >> 4 & 15u), int(offset >> 8));
    }
};

} // namespace core
