// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkTree.h"

namespace core {

/// What the voxels show about the chunks of the finest division ("leaves"): which of them touch,
/// whatever their owners, how much alike they are there, and where the middle of each is. All
/// numbers are integers.
struct ChunkSurvey {
    /// The alikeness of two voxels with equal values.
    static constexpr std::uint64_t alike = 256;

    struct Border {
        ChunkTree::Chunk first = 0;
        ChunkTree::Chunk second = 0; ///< greater than first
        std::uint32_t faces = 0; ///< number of voxel faces that they share
        /// The sum of the alikeness over these faces. A face counts `alike` without a difference,
        /// half of that where the difference equals the noise (ChunkTree::noise()), and a tenth
        /// where it is three times the noise. The difference used is the greater of two: the one
        /// between the means of both chunks, and half of the one across the face. So noise does not
        /// make a border, but a thin wall between two parts of the same value does.
        std::uint64_t bond = 0;
        [[nodiscard]] std::uint64_t pair() const { return std::uint64_t(first) << 32U | second; }
        bool operator==(const Border&) const = default;
    };

    glm::ivec3 size{0}; ///< size of the box, in voxels
    std::vector<Border> borders; ///< each pair once, in ascending order
    /// For each leaf, its voxel nearest to its centroid; index in the box.
    std::vector<std::uint32_t> middles;

    /// Surveys a division. Cost: two passes over the box, on all cores.
    /// @param source the one from which @p tree was made
    [[nodiscard]] static ChunkSurvey of(const ChunkSource& source, const ChunkTree& tree);
};

} // namespace core
