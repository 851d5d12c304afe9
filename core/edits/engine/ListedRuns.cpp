// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/ListedRuns.h"

#include "core/brick/RunRows.h"

#include <algorithm>
#include <utility>

namespace core {

ListedRuns::ListedRuns(const glm::ivec3& volumeSize)
    : m_grid{volumeSize}
{
}

void ListedRuns::add(const VoxelRuns& runs, std::uint8_t asked)
{
    const glm::ivec3 count = m_grid.bricks();
    int known = -1; // the row of bricks that is at hand: runs have it for many rows of voxels
    RowOfBricks* row = nullptr;
    forEachRowPart(runs, m_grid.volumeSize, [&](const glm::ivec3& at, int length, std::uint64_t) {
        const int number = at.y / BrickGrid::side + count.y * (at.z / BrickGrid::side);
        if (number != known) {
            row = &m_rows[number];
            row->resize(std::size_t(count.x));
            known = number;
        }
        const int rowInBrick = BrickGrid::offsetInBrick({0, at.y, at.z});
        const int end = at.x + length;
        for (int x = at.x; x < end;) {
            std::vector<std::uint8_t>& brick = (*row)[std::size_t(x / BrickGrid::side)];
            if (brick.empty())
                brick.assign(BrickGrid::voxelsPerBrick, std::uint8_t(0));
            const int in = x % BrickGrid::side;
            const int part = std::min(BrickGrid::side - in, end - x);
            std::fill_n(brick.begin() + rowInBrick + in, part, asked);
            x += part;
        }
    });
}

template <class Brick> std::vector<Brick> ListedRuns::takeBricks()
{
    const int along = m_grid.bricks().x;
    std::vector<Brick> bricks;
    for (auto& [number, row] : std::exchange(m_rows, {})) {
        for (int x = 0; x < along; ++x) {
            if (std::vector<std::uint8_t>& each = row[std::size_t(x)]; !each.empty())
                bricks.push_back({std::uint32_t(number * along + x), std::move(each)});
        }
    }
    return bricks;
}

RelabelListed ListedRuns::relabel(LabelTarget target)
{
    return {.target = std::move(target), .bricks = takeBricks<RelabelListed::Brick>()};
}

LabelListed ListedRuns::label(
    std::uint8_t plane, const std::bitset<256>& overwritable, std::uint8_t frees)
{
    return {.plane = plane,
        .overwritable = overwritable,
        .bricks = takeBricks<LabelListed::Brick>(),
        .frees = frees};
}

} // namespace core
