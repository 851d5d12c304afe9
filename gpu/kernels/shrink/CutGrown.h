// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/GrowthCommands.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"

#include <vector>

namespace gpu {

/// The result of cutGrown().
struct CutOutcome {
    std::vector<core::BrickKey> keys; ///< bricks that were written
    std::uint32_t generation = 0; ///< generation counter after the cut
};

/// Takes back what grew through some places (core/growth/cut/GrowthCut.h). This search does not
/// suit a kernel: the seed words are read back, the processor decides, and the bricks that change
/// are captured and written. Engine thread only. Errors: as core::cutGrowth().
core::Result<CutOutcome> cutGrown(
    VoxelFields& fields, BeforeImages& before, const core::CutGrowth& command);

} // namespace gpu
