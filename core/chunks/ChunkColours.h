// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkTree.h"

#include <utility>

namespace core {

/// Which colour of a small palette each chunk of a division is drawn in, so that chunks that touch
/// (six neighbours) differ wherever the palette allows it. One that stays a chunk while the slider
/// moves mostly keeps its colour. Decides no voxel.
class ChunkColours {
public:
    static constexpr int colours = 16;

    /// @param size of the tree's box. Cost: one pass over it.
    ChunkColours(const ChunkTree& tree, const glm::ivec3& size);

    /// By chunk of the finest division (ChunkTree::leafAt), 0 … colours − 1. Cost ∝ how many of
    /// these touch.
    [[nodiscard]] std::vector<std::uint8_t> of(const ChunkTree& tree, int count) const;

private:
    std::vector<std::pair<ChunkTree::Chunk, ChunkTree::Chunk>> m_contacts; ///< of the finest
};

} // namespace core
