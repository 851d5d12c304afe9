// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkSurvey.h"

#include <array>

namespace core {

/// Which chunks a user will most likely want to add to a segment or to take from it: those that
/// hang together more with the other side of its border than with their own. Decides no voxel;
/// whole numbers only, so that the same is offered on every machine.
///
/// The doubt of a chunk is its size, less by three shares. Outside the segment:
/// 1. of its bonds with everything around it (ChunkSurvey::Border), those with the segment;
/// 2. how alike both sides of its border with the segment are, and how wide that border is beside
/// the side of a cube of its size: a missing lobe has a wide contact and no edge there;
/// 3. how little likelier it is outside (ChunkTree::likelihood()), squared.
/// Inside, with the bonds to the rest of the segment counted as faces that are wholly alike:
/// 1. of these and its faces to the outside, the latter: what lies within is not in doubt;
/// 2. how narrow they are: a leak has a neck, and as many as a side of a cube of its size are none;
/// 3. how little likely it is inside.
/// A chunk of which less than a sixteenth is left is not in doubt.
/// A chunk outside counts if it is not larger than the segment, one inside if it is not larger than
/// half of it.
class DoubtfulChunks {
public:
    using Chunk = ChunkTree::Chunk;
    struct Doubtful {
        Chunk chunk = 0;
        bool isInside = false; ///< a click takes it away; else a click adds it
        std::int64_t doubt = 0; ///< in voxels
        std::uint32_t middle = 0; ///< a voxel of it, about in its middle; index in the box
        bool operator==(const Doubtful&) const = default;
    };

    /// @param segment its label: chunks of further owners are never in doubt
    /// @param isInside by leaf: whether the segment has more than half of it
    /// Cost ∝ the borders, times how often their chunks are joined before they are one.
    DoubtfulChunks(const ChunkTree& tree, const ChunkSurvey& survey, std::uint8_t segment,
        std::vector<bool> isInside);

    /// Which leaves a segment has when the division is new.
    [[nodiscard]] static std::vector<bool> ownedBy(const ChunkTree& tree, std::uint8_t segment);

    /// The most doubtful chunks of a division, the first most; fewer if there is less doubt.
    [[nodiscard]] std::vector<Doubtful> of(int count, std::size_t most) const;
    /// The least number of chunks at which the most doubtful chunk of the whole tree stands by
    /// itself, and the two that come next unless they are much less in doubt, or take many more
    /// chunks; none: nothing is in doubt.
    [[nodiscard]] std::optional<int> suggestedCount() const;

private:
    /// What lies around a chunk, on each side: 0 outside, 1 inside.
    struct Around {
        std::array<std::int64_t, 2> bonds{};
        std::array<std::int64_t, 2> faces{};
        Around& operator+=(const Around& other);
        Around& operator-=(const Around& other);
    };

    [[nodiscard]] std::vector<Around> lookAround() const;
    [[nodiscard]] bool isInside(Chunk chunk) const;
    [[nodiscard]] std::int64_t doubtOf(Chunk chunk, const Around& around) const;
    /// Those of some chunks that are worth a look, the most doubtful first.
    [[nodiscard]] std::vector<Chunk> inOrder(std::vector<Chunk> chunks) const;
    [[nodiscard]] std::uint32_t middleOf(Chunk chunk, const std::vector<Chunk>& ofLeaves) const;

    const ChunkTree& m_tree;
    const ChunkSurvey& m_survey;
    std::uint8_t m_segment;
    std::vector<bool> m_leafIsInside;
    std::vector<std::int64_t> m_held; ///< by chunk: voxels of leaves that are inside
    std::int64_t m_allHeld = 0;
    std::vector<std::int64_t> m_doubts; ///< by chunk
};

} // namespace core
