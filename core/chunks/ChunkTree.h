// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkField.h"

#include <optional>

namespace core {

/// A hierarchical division of a box of voxels into chunks, coarse to fine (seed B, section 4.2): a
/// slider selects the number of chunks, and clicks add or remove them.
///
/// Small compact pieces of one owner with similar voxels (ChunkField) are joined in pairs, each
/// time the two with the lowest price: their difference in value and likelihood, times their size
/// (the harmonic mean, so that the smaller one counts most), times the narrowness of their contact.
/// So noise is joined first, and parts that a neck or a change of values separates stay separate to
/// the end. Every join is a chunk of the tree, and keeps its number whatever the slider says.
class ChunkTree {
public:
    using Chunk = std::uint32_t;
    /// The greatest number of chunks; there are fewer if there are fewer pieces.
    static constexpr int mostChunks = 5000;

    /// Computes it. Cost: about ten passes over the box, and a queue of its pieces (about one for
    /// 40 voxels). Errors: InvalidField (sizes that do not agree), Cancelled.
    [[nodiscard]] static Result<ChunkTree> of(const ChunkSource& source, const Progress& progress);

    /// The number of chunks that are never joined: different owners, and parts of one owner that do
    /// not touch.
    [[nodiscard]] int fewest() const { return int(m_leaves) - int(m_joins.size()); }
    [[nodiscard]] int finest() const { return int(m_leaves); }

    /// All chunks of the tree are numbered 0 … chunkCount() − 1: those of the finest division, then
    /// the joins in their order, so that a chunk stands before the one that it is joined into.
    [[nodiscard]] Chunk chunkCount() const { return Chunk(m_parents.size()); }
    /// The chunk into which a chunk is joined; none: it is joined with no other.
    [[nodiscard]] std::optional<Chunk> parent(Chunk chunk) const;
    /// The least and the greatest number of chunks at which a chunk stands by itself.
    [[nodiscard]] int fewestWith(Chunk chunk) const;
    [[nodiscard]] int mostWith(Chunk chunk) const;
    /// As ChunkField::noise().
    [[nodiscard]] int noise() const { return m_noise; }

    /// The chunks of a division into @p count chunks, ascending; count is between fewest() and
    /// finest().
    [[nodiscard]] std::vector<Chunk> division(int count) const;
    /// The one that contains a voxel of the box; none: the voxel was left out.
    [[nodiscard]] std::optional<Chunk> chunkAt(std::size_t voxel, int count) const;
    /// The chunk of the finest division that contains a voxel, 0 … finest() − 1; for drawing.
    [[nodiscard]] std::optional<Chunk> leafAt(std::size_t voxel) const;
    /// The same for all voxels of the box; noLeaf: the voxel was left out.
    static constexpr Chunk noLeaf = ~Chunk(0);
    [[nodiscard]] std::span<const Chunk> leaves() const { return m_leafOfVoxel; }
    /// For each chunk of the finest division, the chunk of a division that contains it.
    [[nodiscard]] std::vector<Chunk> chunksOfLeaves(int count) const;
    /// The voxels of a chunk, by their index in the box. Cost: none.
    [[nodiscard]] std::span<const std::uint32_t> voxels(Chunk chunk) const;
    [[nodiscard]] std::uint8_t owner(Chunk chunk) const;
    /// The mean over its voxels, −ChunkField::most … most.
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
    static constexpr std::uint32_t none = noLeaf;

    void order();
    /// The first chunk that a division does not contain yet; `none` is beyond it, too.
    [[nodiscard]] std::uint32_t firstUnmade(int count) const;

    int m_noise = 1;
    std::uint32_t m_leaves = 0; ///< chunks below this number are not joins
    std::vector<Join> m_joins; ///< chunk m_leaves + i, in the order of joining
    std::vector<std::uint32_t> m_parents; ///< by chunk; none: it is part of no join
    std::vector<Span> m_spans; ///< by chunk, in m_voxels
    std::vector<std::uint32_t> m_voxels; ///< of all chunks; those of a chunk are contiguous
    std::vector<std::uint32_t> m_leafOfVoxel;
    std::vector<std::uint8_t> m_owners; ///< by chunk
    std::vector<std::int16_t> m_likelihoods; ///< by chunk
};

} // namespace core
