// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/kernels/shrink/PreviewMarks.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

/// In which voxels an open growth differs from what was there when it began (core::CompareGrowth).
struct ComparedGrowth {
    core::GrowthComparison counts;
    std::vector<PreviewMarks::Brick> bricks; ///< ascending; those that differ
};

/// Where the plane has another label than before, a member of the growth has claimed the voxel;
/// what is no member has left it. The cost follows the bricks that the growth has touched since it
/// was opened or was told another interval. Waits for the GPU.
/// @param touched what the growth may have written; all of it was captured
[[nodiscard]] ComparedGrowth compareGrowth(VoxelFields& fields, BeforeImages& before,
    std::uint8_t plane, const std::vector<core::BrickKey>& touched);
/// The same of a growth that has ended.
/// @param changes all that it has changed
[[nodiscard]] ComparedGrowth compareGrowth(
    VoxelFields& fields, std::uint8_t plane, std::span<const core::BrickChange> changes);

} // namespace gpu
