// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/front/BrickFront.h"

#include <bitset>
#include <span>

namespace core {

/// What the seed words of a brick say to a growth that goes on.
struct GrownBrick {
    VoxelBits members{}; ///< those whose label may grow
    std::bitset<256> labels{}; ///< theirs
    bool hasPendingSeeds = false;
};

/// @param words `BrickGrid::voxelsPerBrick` of them
/// @param lockedLabels labels that do not grow
[[nodiscard]] GrownBrick grownBrick(
    std::span<const std::uint32_t> words, const std::bitset<256>& lockedLabels);

} // namespace core
