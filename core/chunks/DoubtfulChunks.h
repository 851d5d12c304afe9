// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkSurvey.h"

#include <array>

namespace core {

/// Finds the chunks that a user will most likely want to add to a segment or remove from it: those
/// that are connected more strongly with the other side of the segment's border than with their
/// own. It only offers chunks and changes no voxel. All numbers are integers, so that every machine
/// offers the same.
///
/// The doubt of a chunk is its number of voxels, multiplied by three factors from 0 to 1. For a
/// chunk outside the segment they are
/// 1. its bonds with the segment (ChunkSurvey::Border), as a share of its bonds with everything
///    around it;
/// 2. how much alike both sides of its border with the segment are, times how wide that border is
///    compared with a side of a cube of the chunk's size: a missing lobe has a wide contact without
///    an edge;
/// 3. the square of how little its likelihood speaks for the outside (ChunkTree::likelihood()).
///
/// For a chunk inside the segment, with its contact being its bonds to the rest of the segment,
/// counted as faces that are wholly alike, they are
/// 1. its faces to the outside, as a share of these and the contact: a chunk that lies deep inside
///    is not in doubt;
/// 2. how narrow the contact is: a leak has a neck. A contact as wide as a side of a cube of the
///    chunk's size gives 0;
/// 3. how little its likelihood speaks for the inside.
///
/// A chunk for which less than a sixteenth of its voxels results is not in doubt. Chunks outside
/// count only if they are not larger than the segment, chunks inside only if they are not larger
/// than half of it.
class DoubtfulChunks {
public:
    using Chunk = ChunkTree::Chunk;
    struct Doubtful {
        Chunk chunk = 0;
        bool isInside = false; ///< a click removes it from the segment; otherwise a click adds it
        std::int64_t doubt = 0; ///< in voxels
        std::uint32_t middle = 0; ///< one of its voxels, near its centroid; index in the box
        bool operator==(const Doubtful&) const = default;
    };

    /// @param segment its label; chunks of other segments are never in doubt
    /// @param isInside for each leaf, whether the segment has more than half of its voxels
    /// Cost ∝ the number of borders, times the levels of the tree. The tree and the survey must
    /// outlive this.
    DoubtfulChunks(const ChunkTree& tree, const ChunkSurvey& survey, std::uint8_t segment,
        std::vector<bool> isInside);

    /// For each leaf, whether the segment owned it when the division was made.
    [[nodiscard]] static std::vector<bool> ownedBy(const ChunkTree& tree, std::uint8_t segment);

    /// The most doubtful chunks of the division into @p count chunks, in descending order of doubt;
    /// at most @p most, and fewer if fewer are in doubt.
    [[nodiscard]] std::vector<Doubtful> of(int count, std::size_t most) const;
    /// The smallest number of chunks at which the most doubtful chunk of the whole tree stands by
    /// itself. The next two are separate as well, unless their doubt is much smaller or this would
    /// take many more chunks. None if nothing is in doubt.
    [[nodiscard]] std::optional<int> suggestedCount() const;

private:
    /// The sums over the borders of a chunk with leaves outside the segment (0) and inside it (1).
    struct Around {
        std::array<std::int64_t, 2> bonds{};
        std::array<std::int64_t, 2> faces{};
        Around& operator+=(const Around& other);
        Around& operator-=(const Around& other);
    };

    [[nodiscard]] std::vector<Around> lookAround() const;
    [[nodiscard]] bool isInside(Chunk chunk) const;
    [[nodiscard]] std::int64_t doubtOf(Chunk chunk, const Around& around) const;
    /// Removes chunks of too little doubt and sorts the rest in descending order of doubt.
    [[nodiscard]] std::vector<Chunk> inOrder(std::vector<Chunk> chunks) const;
    [[nodiscard]] std::uint32_t middleOf(Chunk chunk, const std::vector<Chunk>& ofLeaves) const;

    const ChunkTree& m_tree;
    const ChunkSurvey& m_survey;
    std::uint8_t m_segment;
    std::vector<bool> m_leafIsInside;
    std::vector<std::int64_t> m_held; ///< for each chunk, the voxels of its leaves that are inside
    std::int64_t m_allHeld = 0;
    std::vector<std::int64_t> m_doubts; ///< by chunk
};

} // namespace core
