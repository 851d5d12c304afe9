// SPDX-License-Identifier: Apache-2.0
#include "core/session/SurfaceWriteBack.h"

#include "core/brick/BrickGrid.h"

namespace core {

RelabelListed writeBackOf(const VoxelRuns& inside, const std::vector<std::uint8_t>& labels,
    const glm::ivec3& size, const LabelTarget& target)
{
    const BrickGrid grid{size};
    std::vector<std::vector<std::uint8_t>> bricks(std::size_t(grid.brickCount()));
    const auto ask = [&](std::uint64_t at, std::uint8_t what) {
        const glm::ivec3 voxel(int(at % std::uint64_t(size.x)),
            int(at / std::uint64_t(size.x) % std::uint64_t(size.y)),
            int(at / std::uint64_t(size.x) / std::uint64_t(size.y)));
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

} // namespace core
