// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/front/BrickFront.h"

#include <bitset>
#include <span>

namespace core {

/// The parts of a brick's seed words that matter to a growth that goes on.
struct GrownBrick {
    VoxelBits members{}; ///< the voxels that are members of a label that may grow
    std::bitset<256> labels{}; ///< the labels of these members
    bool hasPendingSeeds = false;
};

/// Reads them.
/// @param words `BrickGrid::voxelsPerBrick` of them
/// @param lockedLabels labels that do not grow
[[nodiscard]] GrownBrick grownBrick(
    std::span<const std::uint32_t> words, const std::bitset<256>& lockedLabels);

} // namespace core
