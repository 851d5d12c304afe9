// SPDX-License-Identifier: Apache-2.0
#include "core/growth/coarse/CoarseGrid.h"

namespace core {

CoarseGrid CoarseGrid::of(
    const glm::ivec3& volumeSize, const glm::dvec3& spacingMm, std::int64_t mostCells)
{
    CoarseGrid grid{.volumeSize = volumeSize};
    while (std::int64_t(grid.cellCount()) > mostCells) {
        // The shortest side is lengthened, of those that still divide anything.
        const glm::ivec3 cells = grid.size();
        int shortest = -1;
        for (int axis = 0; axis < 3; ++axis) {
            if (cells[axis] > 1
                && (shortest < 0
                    || grid.cell[axis] * spacingMm[axis]
                        < grid.cell[shortest] * spacingMm[shortest]))
                shortest = axis;
        }
        if (shortest < 0)
            break;
        ++grid.cell[shortest];
    }
    return grid;
}

std::size_t CoarseGrid::cellCount() const
{
    const glm::ivec3 cells = size();
    return std::size_t(cells.x) * std::size_t(cells.y) * std::size_t(cells.z);
}

std::int64_t CoarseGrid::voxelsIn(const glm::ivec3& place) const
{
    const glm::ivec3 first = place * cell;
    const glm::i64vec3 sides(glm::min(first + cell, volumeSize) - first);
    return sides.x * sides.y * sides.z;
}

CoarseCodes::CoarseCodes(const CoarseGrid& grid)
    : m_grid(grid)
    , m_codes(grid.cellCount())
{
}

void CoarseCodes::takeSlice(int layer, std::span<const std::uint16_t> slice)
{
    const glm::ivec3 cells = m_grid.size();
    std::size_t number = m_grid.numberOf({0, 0, layer});
    for (int y = 0; y < cells.y; ++y) {
        for (int x = 0; x < cells.x; ++x, ++number) {
            const glm::ivec3 voxel = m_grid.sampleOf({x, y, layer});
            m_codes[number] = slice[std::size_t(voxel.y) * std::size_t(m_grid.volumeSize.x)
                + std::size_t(voxel.x)];
        }
    }
}

} // namespace core
