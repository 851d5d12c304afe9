// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/MaskScissors.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/kernels/cut/MaskPrograms.h"

namespace gpu {

/// Carries out core::MaskScissors, as one gather over the bricks below the mask.
struct Scissored {
    std::vector<std::uint32_t> bricks; ///< that changed
    std::optional<std::int32_t> searchedTo{}; ///< how deep the surface was looked for
};
[[nodiscard]] Scissored cutWithScissors(MaskPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::MaskScissors& scissors);

} // namespace gpu
