// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/kernels/shrink/PreviewMarks.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

/// The voxels in which an open growth differs from the state before it began (core::CompareGrowth).
struct ComparedGrowth {
    core::GrowthComparison counts;
    std::vector<PreviewMarks::Brick> bricks; ///< bricks with changed labels, ascending
};

/// Compares the labels of an open growth with those before it. A voxel with another label is marked
/// Reached if it is a member of the growth now, and else Suspended. Cost: proportional to the
/// bricks that the growth has touched since it was opened or got another interval. Waits for the
/// GPU.
/// @param touched what the growth may have written; all of it was captured
[[nodiscard]] ComparedGrowth compareGrowth(VoxelFields& fields, BeforeImages& before,
    std::uint8_t plane, const std::vector<core::BrickKey>& touched);
/// The same for a growth that has ended.
/// @param changes all changes of the growth
[[nodiscard]] ComparedGrowth compareGrowth(
    VoxelFields& fields, std::uint8_t plane, std::span<const core::BrickChange> changes);

} // namespace gpu
