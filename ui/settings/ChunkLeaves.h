// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkColours.h"
#include "core/chunks/ChunkMap.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace ui {

/// Data about a division into chunks that the window computes once: the chunks of its finest level
/// ("leaves") by voxel, their sizes, and which of them touch. Immutable; may be used on any thread.
struct ChunkLeaves {
    /// @param segment that is divided
    /// Cost: a few passes over the box.
    ChunkLeaves(std::shared_ptr<const core::ChunkMap> chunks, int segment);

    std::shared_ptr<const core::ChunkMap> map;
    /// By voxel of the box, x fastest: leaf + 1, or 0 for none (gpu::SceneChunks).
    std::shared_ptr<const std::vector<std::uint16_t>> ofVoxel;
    std::vector<std::uint32_t> voxels; ///< by leaf
    core::ChunkColours colours;
    /// The number of chunks at which what is most in doubt stands by itself
    /// (core::DoubtfulChunks); none: nothing is in doubt.
    std::optional<int> suggestedCount;
};

/// A chunk with fewer voxels that is joined with no other one is a speck; it is smaller than the
/// pieces that chunks are joined of (core::ChunkPieces).
constexpr std::size_t speckVoxels = 64;
/// How many specks there are.
/// @param voxelsOfCell for a tree of cells: how many voxels each of them stands for
[[nodiscard]] int specksOf(const core::ChunkTree& tree, int voxelsOfCell = 1);

} // namespace ui
