// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/CoarseScene.h"

#include "core/chunks/CoarseChunks.h"
#include "ui/settings/ChunkLeaves.h"
#include "ui/settings/ChunkShades.h"

#include <algorithm>

namespace ui {

std::shared_ptr<const gpu::SceneChunks> coarseScene(
    const core::CoarseChunks& chunks, const CoarseLook& look)
{
    const core::ChunkTree& tree = chunks.tree;
    const int specks = specksOf(tree, chunks.cell * chunks.cell * chunks.cell);
    const int count = std::clamp(look.count + specks, tree.fewest(), tree.finest());
    const std::vector<std::uint8_t> colours = chunks.colours.of(tree, count);
    auto scene = std::make_shared<gpu::SceneChunks>();
    scene->box = chunks.box;
    scene->cell = glm::ivec3(chunks.cell);
    scene->leaves = chunks.leaves;
    scene->opacity = look.opacity;
    for (const core::ChunkTree::Chunk chunk : tree.chunksOfLeaves(count)) {
        const bool isOwn = int(tree.owner(chunk)) == look.segment;
        scene->argb.push_back(argbOf({.colour = colours[scene->argb.size()],
            .isOwn = isOwn,
            .isHidden = !isOwn && look.isHidden && look.isHidden(tree.likelihood(chunk))}));
    }
    return scene;
}

} // namespace ui
