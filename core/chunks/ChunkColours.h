// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkTree.h"

#include <utility>

namespace core {

/// Assigns colours of a small palette to the chunks of a division, so that chunks that touch (six
/// neighbours) differ wherever the palette allows it. A chunk that does not change while the slider
/// moves mostly keeps its colour. Decides no voxel.
class ChunkColours {
public:
    static constexpr int colours = 16;

    /// @param size of the tree's box. Cost: one pass over it.
    ChunkColours(const ChunkTree& tree, const glm::ivec3& size);

    /// By chunk of the finest division (ChunkTree::leafAt), 0 … colours − 1. Cost ∝ the number of
    /// contacts between these.
    [[nodiscard]] std::vector<std::uint8_t> of(const ChunkTree& tree, int count) const;

private:
    /// of the finest division
    std::vector<std::pair<ChunkTree::Chunk, ChunkTree::Chunk>> m_contacts;
};

} // namespace core
