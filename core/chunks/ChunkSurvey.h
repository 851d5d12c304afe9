// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkTree.h"

namespace core {

/// What voxels tell of the chunks of the finest division ("leaves"): where they touch, whoever owns
/// them, and where their middles are. All numbers are integers.
struct ChunkSurvey {
    /// The alikeness of two voxels that do not differ.
    static constexpr std::uint64_t alike = 256;

    struct Border {
        ChunkTree::Chunk first = 0;
        ChunkTree::Chunk second = 0; ///< greater than first
        std::uint32_t faces = 0; ///< at which voxels of both are neighbours (six)
        /// The sum of the faces' alikeness: `alike` without a difference, half of it if the
        /// difference is one mean deviation, a tenth if it is three. The difference is that of the
        /// two chunks' means, or half of that across the face if it is greater: noise is no border,
        /// and a wall between two parts of the same value is one.
        std::uint64_t bond = 0;
        [[nodiscard]] std::uint64_t pair() const { return std::uint64_t(first) << 32U | second; }
        bool operator==(const Border&) const = default;
    };

    glm::ivec3 size{0}; ///< of the box
    std::vector<Border> borders; ///< each pair once, ascending
    std::vector<std::uint32_t> middles; ///< by leaf: its voxel that is nearest to its centre

    /// Cost: two passes over the box, on all cores.
    /// @param source of which the tree was made
    [[nodiscard]] static ChunkSurvey of(const ChunkSource& source, const ChunkTree& tree);
};

} // namespace core
