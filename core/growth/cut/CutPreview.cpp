// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/CutPreview.h"

#include "core/growth/SeedWord.h"

#include <algorithm>

namespace core {

Result<LeavingBricks> leavingBricks(const WordBricks& words, const CutGrowth& command)
{
    const Result<LeavingVoxels> found = leavingVoxels(words, command);
    if (!found)
        return tl::unexpected(found.error());
    LeavingBricks leaving;
    constexpr std::size_t none = std::size_t(-1);
    std::vector<std::size_t> places(words.count() >> 12, none);
    for (const auto& [label, voxels] : *found) {
        leaving.members += std::int64_t(voxels.size());
        for (const WordBricks::Voxel voxel : voxels) {
            if (seedWord::wasHeld(words[voxel]))
                continue;
            std::size_t& place = places[voxel >> 12];
            if (place == none) {
                place = leaving.bricks.size();
                leaving.bricks.push_back({words.brickOf(voxel),
                    std::vector<std::uint8_t>(std::size_t(BrickGrid::voxelsPerBrick), 0)});
            }
            leaving.bricks[place].labels[voxel & 4095u] = std::uint8_t(label);
        }
    }
    std::sort(leaving.bricks.begin(), leaving.bricks.end(),
        [](const auto& a, const auto& b) { return a.brick < b.brick; });
    return leaving;
}

CutPreview cutPreview(const LeavingBricks& leaving, std::span<const std::vector<std::uint8_t>> held)
{
    CutPreview preview{.members = leaving.members};
    for (std::size_t i = 0; i < leaving.bricks.size(); ++i) {
        CutPreview::Brick brick{.brick = leaving.bricks[i].brick, .taken = {}};
        for (std::size_t voxel = 0; voxel < held[i].size(); ++voxel) {
            const std::uint8_t label = leaving.bricks[i].labels[voxel];
            brick.taken[voxel] = label != 0 && held[i][voxel] == label;
        }
        if (brick.taken.none())
            continue;
        preview.voxels += std::int64_t(brick.taken.count());
        preview.bricks.push_back(brick);
    }
    return preview;
}

} // namespace core
