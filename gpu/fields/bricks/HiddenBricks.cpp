// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/bricks/HiddenBricks.h"

#include <algorithm>

namespace gpu {

void setHidden(Program& program, const std::vector<core::IntegerHalfSpace>& hidden)
{
    std::vector<glm::ivec4> perVoxel;
    for (const core::IntegerHalfSpace& half : hidden)
        perVoxel.emplace_back(half.perVoxel, 0);
    program.set("hiddenCount", int(perVoxel.size()));
    if (!perVoxel.empty())
        program.set("hiddenPerVoxel", std::span<const glm::ivec4>(perVoxel));
}

Buffer hiddenBases(const std::vector<core::IntegerHalfSpace>& hidden, const core::BrickGrid& grid,
    std::span<const std::uint32_t> candidates)
{
    std::vector<std::int32_t> bases;
    for (const std::uint32_t brick : candidates) {
        const std::vector<std::int32_t> base =
            core::hiddenBase(hidden, grid.boxOf(int(brick)).minimum);
        bases.insert(bases.end(), base.begin(), base.end());
    }
    bases.resize(std::max<std::size_t>(bases.size(), 1));
    Buffer buffer({.label = "hidden bases", .bytes = bases.size() * sizeof(std::int32_t)});
    buffer.write(std::span<const std::int32_t>(bases));
    return buffer;
}

} // namespace gpu
