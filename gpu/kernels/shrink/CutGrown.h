// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/engine/EngineCommands.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"

#include <vector>

namespace gpu {

struct CutOutcome {
    std::vector<core::BrickKey> keys; ///< that were written
    std::uint32_t generation = 0; ///< the counter now
};

/// Takes back what grew through some places (core/growth/cut/GrowthCut.h). Fronts and passages are
/// no work for kernels: the seed words are read back, the processor decides, and the bricks that
/// change are captured and written. Engine thread only. Errors: as core::cutGrowth().
core::Result<CutOutcome> cutGrown(
    VoxelFields& fields, BeforeImages& before, const core::CutGrowth& command);

} // namespace gpu
