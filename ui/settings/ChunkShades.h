// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace ui {

/// How one chunk is drawn.
struct ChunkShade {
    std::uint8_t colour = 0; ///< of core::ChunkColours
    bool isOwn = false; ///< the segment has it
    bool isLit = false; ///< a tool points at it
    bool isHidden = false;
};

/// Its colour as gpu::SceneChunks has it.
[[nodiscard]] std::uint32_t argbOf(const ChunkShade& shade);

} // namespace ui
