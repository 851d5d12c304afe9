// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/GrowthCommands.h"
#include "core/growth/cut/GrowthCut.h"
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

// The parts of cutGrown(), for cuts that continue while they are open (CutBackwards.h).

/// Reads all seed words of a plane, with links between neighbouring bricks.
[[nodiscard]] core::WordBricks readWords(VoxelFields& fields, std::uint8_t plane);
/// Captures and writes bricks of a cut, which may replace those of an earlier state of the same
/// cut.
/// @return the keys of the bricks that were written
std::vector<core::BrickKey> writeCut(VoxelFields& fields, BeforeImages& before, std::uint8_t plane,
    const std::vector<core::CutBrick>& bricks);

} // namespace gpu
