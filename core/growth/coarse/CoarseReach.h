// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/growth/coarse/CoarseGrid.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace core {

/// What a coarse flood has reached.
struct CoarseReach {
    enum State : std::uint16_t {
        Beyond,
        Reached,
        /// Not reached, larger than a voxel, and touches a reached cell: the border may run through
        /// it.
        Rim,
    };
    static constexpr int margin = 2; ///< cells, so that bodies can be drawn smoothly

    /// Contains all reached cells, extended by the margin within the volume; empty: nothing was
    /// reached.
    VoxelBox cells;
    std::vector<std::uint16_t> states; ///< State of each cell of that box, x fastest
    std::int64_t voxels = 0; ///< about how many voxels were reached
};

/// Marks as Rim the cells that touch a reached cell along axes on which cells have several voxels.
/// @param mayBe whether a cell, given by its index in the grid, may become Rim
void addRim(CoarseReach& reach, const CoarseGrid& grid,
    const std::function<bool(const glm::ivec3& cell)>& mayBe);

/// What was reached, in cells of twice the side along all axes: Reached where at least half of the
/// cells are, Rim where any other is not Beyond.
[[nodiscard]] CoarseReach inDoubledCells(const CoarseReach& reach);

} // namespace core
