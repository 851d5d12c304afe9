// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "gpu/edit/BeforeImages.h"
#include "gpu/edit/VoxelFields.h"

#include <vector>

namespace gpu {

struct ShrinkOutcome {
    std::vector<core::BrickKey> keys; ///< that were written
    std::uint32_t generation = 0; ///< the counter now
};

/// Takes back what a growth added (ShrinkGrowth in core/engine/EngineCommands.h; shrink.comp).
/// Bricks that lose something are looked for first; only those are captured and written. Cost ∝ the
/// bricks that hold seed words. Engine thread only.
ShrinkOutcome shrinkGrowth(
    Program& shrink, VoxelFields& fields, BeforeImages& before, const core::ShrinkGrowth& command);

} // namespace gpu
