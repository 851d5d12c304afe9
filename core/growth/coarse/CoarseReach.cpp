// SPDX-License-Identifier: Apache-2.0
#include "core/growth/coarse/CoarseReach.h"

#include <cstddef>

namespace core {

namespace {

/// @param does called with the first place of each row of a box of this size
template <class Does> void forEachRow(const glm::ivec3& size, Does does)
{
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y)
            does(glm::ivec3(0, y, z));
    }
}

} // namespace

void addRim(CoarseReach& reach, const CoarseGrid& grid,
    const std::function<bool(const glm::ivec3& cell)>& mayBe)
{
    const glm::ivec3 size = reach.cells.maximum - reach.cells.minimum;
    std::vector<std::uint16_t> widened = reach.states;
    std::vector<std::uint16_t> narrow;
    std::size_t step = 1;
    for (int axis = 0; axis < 3; step *= std::size_t(size[axis]), ++axis) {
        // A cell of one voxel has no border in it.
        if (grid.cell[axis] == 1)
            continue;
        narrow = widened;
        std::size_t state = 0;
        forEachRow(size, [&](const glm::ivec3& first) {
            glm::ivec3 at = first;
            for (; at.x < size.x; ++at.x, ++state) {
                if ((at[axis] > 0 && narrow[state - step] != CoarseReach::Beyond)
                    || (at[axis] + 1 < size[axis] && narrow[state + step] != CoarseReach::Beyond))
                    widened[state] = CoarseReach::Reached;
            }
        });
    }
    std::size_t state = 0;
    forEachRow(size, [&](const glm::ivec3& first) {
        for (int x = 0; x < size.x; ++x, ++state) {
            if (widened[state] != reach.states[state]
                && mayBe(reach.cells.minimum + first + glm::ivec3(x, 0, 0)))
                reach.states[state] = CoarseReach::Rim;
        }
    });
}

CoarseReach inDoubledCells(const CoarseReach& reach)
{
    CoarseReach doubled;
    doubled.voxels = reach.voxels;
    if (reach.cells.empty())
        return doubled;
    doubled.cells = {reach.cells.minimum / 2, (reach.cells.maximum + 1) / 2};
    const glm::ivec3 size = doubled.cells.maximum - doubled.cells.minimum;
    struct Count {
        std::uint8_t cells = 0;
        std::uint8_t reached = 0;
        bool isAny = false;
    };
    std::vector<Count> counts(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    std::size_t from = 0;
    for (int z = reach.cells.minimum.z; z < reach.cells.maximum.z; ++z) {
        for (int y = reach.cells.minimum.y; y < reach.cells.maximum.y; ++y) {
            const glm::ivec3 row = glm::ivec3(0, y, z) / 2 - doubled.cells.minimum;
            const std::size_t first =
                (std::size_t(row.z) * std::size_t(size.y) + std::size_t(row.y))
                * std::size_t(size.x);
            for (int x = reach.cells.minimum.x; x < reach.cells.maximum.x; ++x, ++from) {
                Count& count = counts[first + std::size_t(x / 2 - doubled.cells.minimum.x)];
                ++count.cells;
                count.reached += reach.states[from] == CoarseReach::Reached ? 1 : 0;
                count.isAny = count.isAny || reach.states[from] != CoarseReach::Beyond;
            }
        }
    }
    doubled.states.reserve(counts.size());
    for (const Count& count : counts)
        doubled.states.push_back(count.reached > 0 && 2 * count.reached >= count.cells
                ? CoarseReach::Reached
                : count.isAny ? CoarseReach::Rim
                              : CoarseReach::Beyond);
    return doubled;
}

} // namespace core
