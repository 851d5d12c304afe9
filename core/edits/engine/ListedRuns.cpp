// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/ListedRuns.h"

#include <algorithm>
#include <utility>

namespace core {

ListedRuns::ListedRuns(const glm::ivec3& volumeSize)
    : m_grid{volumeSize}
{
}

void ListedRuns::add(const VoxelRuns& runs, std::uint8_t asked)
{
    const auto columns = std::uint64_t(m_grid.volumeSize.x);
    const auto rows = std::uint64_t(m_grid.volumeSize.y);
    for (const VoxelRun& run : runs.runs()) {
        std::uint64_t at = run.first;
        const std::uint64_t end = run.first + run.count;
        while (at < end) {
            const glm::ivec3 voxel(
                int(at % columns), int(at / columns % rows), int(at / columns / rows));
            std::vector<std::uint8_t>& brick = m_bricks[std::uint32_t(m_grid.brickOf(voxel))];
            if (brick.empty())
                brick.assign(BrickGrid::voxelsPerBrick, std::uint8_t(0));
            // The rest of the brick's row, or of the run.
            const auto left = std::uint64_t(BrickGrid::side - voxel.x % BrickGrid::side);
            const std::uint64_t count =
                std::min({left, end - at, columns - std::uint64_t(voxel.x)});
            std::fill_n(
                brick.begin() + BrickGrid::offsetInBrick(voxel), std::ptrdiff_t(count), asked);
            at += count;
        }
    }
}

RelabelListed ListedRuns::relabel(LabelTarget target)
{
    RelabelListed relabel{.target = std::move(target), .bricks = {}};
    for (auto& [brick, each] : std::exchange(m_bricks, {}))
        relabel.bricks.push_back({brick, std::move(each)});
    return relabel;
}

LabelListed ListedRuns::label(
    std::uint8_t plane, const std::bitset<256>& overwritable, std::uint8_t frees)
{
    LabelListed label{.plane = plane, .overwritable = overwritable, .bricks = {}, .frees = frees};
    for (auto& [brick, each] : std::exchange(m_bricks, {}))
        label.bricks.push_back({brick, std::move(each)});
    return label;
}

} // namespace core
