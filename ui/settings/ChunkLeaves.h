// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkColours.h"
#include "core/chunks/ChunkMap.h"

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

} // namespace ui
