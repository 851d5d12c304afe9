// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/MaskScissors.h"
#include "gpu/edit/BeforeImages.h"
#include "gpu/edit/MaskPrograms.h"

namespace gpu {

/// Carries out core::MaskScissors, as one gather over the bricks below the mask.
/// @return the bricks that changed
[[nodiscard]] std::vector<std::uint32_t> cutWithScissors(MaskPrograms& programs,
    VoxelFields& fields, BeforeImages& before, const core::MaskScissors& scissors);

} // namespace gpu
