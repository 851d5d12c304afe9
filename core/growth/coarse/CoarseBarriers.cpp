// SPDX-License-Identifier: Apache-2.0
#include "core/growth/coarse/CoarseBarriers.h"

#include "core/growth/SeedWord.h"

namespace core {

namespace {

constexpr int side = BrickGrid::side;

} // namespace

std::vector<BarrierListed::Brick> barriersIn(const std::vector<BrickImage>& bricks)
{
    std::vector<BarrierListed::Brick> held;
    for (const BrickImage& brick : bricks) {
        if (brick.bytes.empty())
            continue;
        const std::vector<std::uint8_t>& bytes = brick.bytes.read();
        BarrierListed::Brick found{.brick = brick.key.brick};
        for (std::size_t i = 0; i < std::size_t(BrickGrid::voxelsPerBrick); ++i) {
            if (seedWord::wordAt(&bytes[4 * i]) == seedWord::barrier)
                found.places.set(i);
        }
        if (found.places.any())
            held.push_back(found);
    }
    return held;
}

CoarseBarriers::CoarseBarriers(
    const CoarseGrid& grid, const std::vector<BarrierListed::Brick>& bricks)
    : m_grid(grid)
    , m_voxelsOfCell(std::size_t(grid.cell.x) * std::size_t(grid.cell.y) * std::size_t(grid.cell.z))
{
    if (bricks.empty())
        return;
    const BrickGrid brickGrid{grid.volumeSize};
    std::vector<std::uint32_t> known(grid.cellCount()); // by cell: one more than its place here
    for (const BarrierListed::Brick& brick : bricks) {
        const glm::ivec3 first = brickGrid.boxOf(int(brick.brick)).minimum;
        for (int i = 0; i < BrickGrid::voxelsPerBrick; ++i) {
            if (!brick.places.test(std::size_t(i)))
                continue;
            const glm::ivec3 voxel = first + glm::ivec3(i % side, i / side % side, i / side / side);
            if (glm::any(glm::greaterThanEqual(voxel, grid.volumeSize)))
                continue;
            const glm::ivec3 cell = voxel / grid.cell;
            std::uint32_t& number = known[grid.numberOf(cell)];
            if (number == 0) {
                add(cell);
                number = std::uint32_t(m_cells.size());
            }
            const glm::ivec3 local = voxel - cell * grid.cell;
            m_passable[std::size_t(number - 1) * m_voxelsOfCell
                + std::size_t((local.z * grid.cell.y + local.y) * grid.cell.x + local.x)] = 0;
        }
    }
}

/// A cell without barriers.
void CoarseBarriers::add(const glm::ivec3& cell)
{
    m_cells.push_back(cell);
    const glm::ivec3 inside = glm::min(m_grid.volumeSize - cell * m_grid.cell, m_grid.cell);
    for (int z = 0; z < m_grid.cell.z; ++z) {
        for (int y = 0; y < m_grid.cell.y; ++y) {
            for (int x = 0; x < m_grid.cell.x; ++x)
                m_passable.push_back(x < inside.x && y < inside.y && z < inside.z ? 1 : 0);
        }
    }
}

} // namespace core
