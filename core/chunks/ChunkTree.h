// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkField.h"

#include <optional>

namespace core {

/// A box of voxels divided into chunks, coarse to fine (seed B, section 4.2): a slider says into
/// how many, a click adds or takes one away.
///
/// Small compact pieces of one owner and alike (ChunkField) are joined two by two, each time those
/// that hang together best: what they differ by, in value and likelihood, times how large the
/// smaller is, times how narrow the place is at which they meet. So noise goes first, and what a
/// neck or a change of values holds apart stays apart to the end. Every join is a chunk of the
/// tree, and keeps its number whatever the slider says.
class ChunkTree {
public:
    using Chunk = std::uint32_t;
    /// As finely as it is divided at most; coarser where fewer pieces are there.
    static constexpr int mostChunks = 5000;

    /// Cost: some ten passes over the box, and a queue of its pieces (about one for 40 voxels).
    /// Errors: InvalidField (sizes that do not agree), Cancelled.
    [[nodiscard]] static Result<ChunkTree> of(const ChunkSource& source, const Progress& progress);

    /// What is never joined: owners, and parts of one that do not touch.
    [[nodiscard]] int fewest() const { return int(m_leaves) - int(m_joins.size()); }
    [[nodiscard]] int finest() const { return int(m_leaves); }

    /// The chunks of a division into so many, ascending; within fewest() and finest().
    [[nodiscard]] std::vector<Chunk> division(int count) const;
    /// Which of them holds a voxel of the box; none: it was left out.
    [[nodiscard]] std::optional<Chunk> chunkAt(std::size_t voxel, int count) const;
    /// Which chunk of the finest division holds it, 0 … finest() − 1: for whoever draws them.
    [[nodiscard]] std::optional<Chunk> leafAt(std::size_t voxel) const;
    /// Which chunk of a division holds each chunk of the finest one.
    [[nodiscard]] std::vector<Chunk> chunksOfLeaves(int count) const;
    /// The voxels of a chunk, by their places in the box. Cost: none.
    [[nodiscard]] std::span<const std::uint32_t> voxels(Chunk chunk) const;
    [[nodiscard]] std::uint8_t owner(Chunk chunk) const;
    /// On average, −ChunkField::most … most.
    [[nodiscard]] int likelihood(Chunk chunk) const;

private:
    struct Join {
        Chunk first = 0;
        Chunk second = 0;
    };
    struct Span {
        std::uint32_t begin = 0;
        std::uint32_t count = 0;
    };
    static constexpr std::uint32_t none = ~std::uint32_t(0);

    void order();
    /// The first chunk that a division does not know of yet; `none` is beyond it, too.
    [[nodiscard]] std::uint32_t firstUnmade(int count) const;

    std::uint32_t m_leaves = 0; ///< chunks below this are no joins
    std::vector<Join> m_joins; ///< chunk m_leaves + i, in the order of joining
    std::vector<std::uint32_t> m_parents; ///< by chunk; none: it is in no join
    std::vector<Span> m_spans; ///< by chunk, in m_voxels
    std::vector<std::uint32_t> m_voxels; ///< of all chunks, each chunk's beside each other
    std::vector<std::uint32_t> m_leafOfVoxel;
    std::vector<std::uint8_t> m_owners; ///< by chunk
    std::vector<std::int16_t> m_likelihoods; ///< by chunk
};

} // namespace core
