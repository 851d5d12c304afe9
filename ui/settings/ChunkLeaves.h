// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkColours.h"
#include "core/chunks/ChunkMap.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace ui {

/// What a window makes of a division once: the chunks of the finest one ("leaves") by voxel, how
/// large they are, and which of them touch. Of any thread; nothing changes afterwards.
struct ChunkLeaves {
    /// Cost: some passes over the box.
    explicit ChunkLeaves(std::shared_ptr<const core::ChunkMap> chunks);

    std::shared_ptr<const core::ChunkMap> map;
    /// By voxel of the box, x fastest: leaf + 1; 0: none (gpu::SceneChunks).
    std::shared_ptr<const std::vector<std::uint16_t>> ofVoxel;
    std::vector<std::uint32_t> voxels; ///< by leaf
    core::ChunkColours colours;
};

} // namespace ui
