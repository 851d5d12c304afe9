// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/ChunkLeaves.h"

#include "core/chunks/DoubtfulChunks.h"

#include <algorithm>
#include <utility>

namespace ui {

namespace {

glm::ivec3 sizeOf(const core::VoxelBox& box)
{
    return box.maximum - box.minimum;
}

} // namespace

ChunkLeaves::ChunkLeaves(std::shared_ptr<const core::ChunkMap> chunks, int segment)
    : map(std::move(chunks))
    , voxels(std::size_t(map->tree().finest()))
    , colours(map->tree(), sizeOf(map->box()))
{
    const glm::ivec3 size = sizeOf(map->box());
    auto leaves = std::make_shared<std::vector<std::uint16_t>>(
        std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    // Leaf by leaf: a chunk knows its voxels.
    for (std::size_t leaf = 0; leaf < voxels.size(); ++leaf) {
        const auto its = map->tree().voxels(core::ChunkTree::Chunk(leaf));
        voxels[leaf] = std::uint32_t(its.size());
        for (const std::uint32_t voxel : its)
            (*leaves)[voxel] = std::uint16_t(leaf + 1);
    }
    ofVoxel = std::move(leaves);
    const auto label = std::uint8_t(segment);
    suggestedCount = core::DoubtfulChunks(
        map->tree(), map->survey(), label, core::DoubtfulChunks::ownedBy(map->tree(), label))
                         .suggestedCount();
}

int specksOf(const core::ChunkTree& tree, int voxelsOfCell)
{
    const std::size_t fewest = std::max<std::size_t>(speckVoxels / std::size_t(voxelsOfCell), 1);
    const std::vector<core::ChunkTree::Chunk> roots = tree.division(tree.fewest());
    return int(std::count_if(roots.begin(), roots.end(),
        [&](core::ChunkTree::Chunk chunk) { return tree.voxels(chunk).size() < fewest; }));
}

} // namespace ui
