// SPDX-License-Identifier: Apache-2.0
#include "core/session/SurfaceWriteBack.h"

#include "core/brick/BrickGrid.h"

#include <algorithm>
#include <map>
#include <utility>

namespace core {

namespace {

/// Columns from and to (not included) of one row.
using Columns = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

/// By row, slices after one another; a run may go on from one row to the next.
std::vector<Columns> rowsOf(const VoxelRuns& voxels, const glm::ivec3& size)
{
    const auto width = std::uint64_t(size.x);
    std::vector<Columns> rows(std::size_t(size.y) * std::size_t(size.z));
    for (const VoxelRun& run : voxels.runs()) {
        const std::uint64_t end = run.first + run.count;
        for (std::uint64_t at = run.first; at < end;) {
            const std::uint64_t row = at / width;
            const std::uint64_t last = std::min(end, (row + 1) * width);
            rows[std::size_t(row)].emplace_back(at - row * width, last - row * width);
            at = last;
        }
    }
    return rows;
}

/// Sorted, those that touch joined.
Columns joined(Columns columns)
{
    std::sort(columns.begin(), columns.end());
    Columns whole;
    for (const auto& [from, to] : columns) {
        if (whole.empty() || whole.back().second < from)
            whole.emplace_back(from, to);
        else
            whole.back().second = std::max(whole.back().second, to);
    }
    return whole;
}

glm::ivec3 voxelAt(std::uint64_t place, const glm::ivec3& size)
{
    const auto width = std::uint64_t(size.x);
    const auto height = std::uint64_t(size.y);
    return {int(place % width), int(place / width % height), int(place / width / height)};
}

} // namespace

RelabelListed writeBackOf(const VoxelRuns& inside, const std::vector<std::uint8_t>& labels,
    const glm::ivec3& size, const LabelTarget& target)
{
    const BrickGrid grid{size};
    std::vector<std::vector<std::uint8_t>> bricks(std::size_t(grid.brickCount()));
    const auto ask = [&](std::uint64_t at, std::uint8_t what) {
        const glm::ivec3 voxel = voxelAt(at, size);
        std::vector<std::uint8_t>& asked = bricks[std::size_t(grid.brickOf(voxel))];
        asked.resize(BrickGrid::voxelsPerBrick, 0);
        asked[std::size_t(BrickGrid::offsetInBrick(voxel))] = what;
    };
    auto run = inside.runs().begin();
    for (std::uint64_t at = 0; at < labels.size(); ++at) {
        while (run != inside.runs().end() && at >= run->first + run->count)
            ++run;
        const bool isInside = run != inside.runs().end() && at >= run->first;
        if (isInside != (labels[at] == target.label))
            ask(at, isInside ? RelabelListed::give : RelabelListed::take);
    }
    RelabelListed edit{.target = target, .bricks = {}};
    for (std::size_t brick = 0; brick < bricks.size(); ++brick) {
        if (!bricks[brick].empty())
            edit.bricks.push_back(
                {.brick = std::uint32_t(brick), .asked = std::move(bricks[brick])});
    }
    return edit;
}

VoxelRuns shellAround(const VoxelRuns& inside, const glm::ivec3& size)
{
    const std::vector<Columns> rows = rowsOf(inside, size);
    const auto width = std::uint64_t(size.x);
    VoxelRuns shell;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            Columns near;
            for (int k = std::max(z - 1, 0); k < std::min(z + 2, size.z); ++k) {
                for (int j = std::max(y - 1, 0); j < std::min(y + 2, size.y); ++j) {
                    for (const auto& [from, to] :
                        rows[std::size_t(k) * std::size_t(size.y) + std::size_t(j)])
                        near.emplace_back(from == 0 ? 0 : from - 1, std::min(to + 1, width));
                }
            }
            const std::size_t row = std::size_t(z) * std::size_t(size.y) + std::size_t(y);
            const auto appendOutside = [&](std::uint64_t from, std::uint64_t to) {
                if (from < to)
                    shell.append(row * width + from, to - from);
            };
            // What is inside in this row lies wholly within what is near.
            auto hole = rows[row].begin();
            for (const auto& [from, to] : joined(std::move(near))) {
                std::uint64_t next = from;
                for (; hole != rows[row].end() && hole->second <= to; ++hole) {
                    appendOutside(next, hole->first);
                    next = hole->second;
                }
                appendOutside(next, to);
            }
        }
    }
    return shell;
}

std::vector<ShutListed::Brick> placesOf(const VoxelRuns& voxels, const glm::ivec3& size)
{
    const BrickGrid grid{size};
    std::map<std::uint32_t, std::bitset<BrickGrid::voxelsPerBrick>> bricks;
    for (const VoxelRun& run : voxels.runs()) {
        for (std::uint64_t at = run.first; at < run.first + run.count; ++at) {
            const glm::ivec3 voxel = voxelAt(at, size);
            bricks[std::uint32_t(grid.brickOf(voxel))].set(
                std::size_t(BrickGrid::offsetInBrick(voxel)));
        }
    }
    std::vector<ShutListed::Brick> listed;
    for (const auto& [brick, places] : bricks)
        listed.push_back({.brick = brick, .places = places});
    return listed;
}

} // namespace core
