// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <functional>
#include <memory>

namespace core {
struct CoarseChunks;
} // namespace core

namespace ui {

/// How coarse chunks are drawn.
struct CoarseLook {
    int segment = 0; ///< label; whose a chunk is was known when it was divided
    int count = 0; ///< wanted number of chunks, without specks
    float opacity = 0.4f;
    /// Whether a chunk of others is left out, by its likelihood; null: none is.
    std::function<bool(int likelihood)> isHidden{};
};

/// What pictures draw of coarse chunks. Cost ∝ those of the finest division.
[[nodiscard]] std::shared_ptr<const gpu::SceneChunks> coarseScene(
    const core::CoarseChunks& chunks, const CoarseLook& look);

} // namespace ui
