// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/growth/GrowthCommands.h"
#include "core/growth/coarse/CoarseGrid.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// The barriers in bricks of seed words, brick by brick; only those that hold any. Cost ∝ the
/// bricks that are not empty.
[[nodiscard]] std::vector<BarrierListed::Brick> barriersIn(const std::vector<BrickImage>& bricks);

/// Where barriers are in the cells of a volume. Barriers are thinner than cells, so a cell that
/// holds any is known voxel by voxel.
class CoarseBarriers {
public:
    /// @param bricks of the grid's volume. Cost ∝ these and the cells.
    CoarseBarriers(const CoarseGrid& grid, const std::vector<BarrierListed::Brick>& bricks);

    /// The places of the cells that hold a barrier.
    [[nodiscard]] const std::vector<glm::ivec3>& cells() const { return m_cells; }
    /// The voxels of the n-th of these, x fastest, as many as a whole cell has: 1 where the volume
    /// has a voxel that is no barrier, else 0.
    [[nodiscard]] std::span<const std::uint8_t> passable(std::size_t n) const
    {
        return std::span(m_passable).subspan(n * m_voxelsOfCell, m_voxelsOfCell);
    }

private:
    void add(const glm::ivec3& cell);

    CoarseGrid m_grid;
    std::size_t m_voxelsOfCell;
    std::vector<glm::ivec3> m_cells;
    std::vector<std::uint8_t> m_passable;
};

} // namespace core
