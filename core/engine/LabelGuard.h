// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/sculpt/ProtectedLabels.h"

#include <bitset>
#include <cstdint>
#include <vector>

namespace core {

/// Labels that must not be changed when whole bricks are put in place. Steps of the past know
/// nothing of segments that were locked or protected since.
struct LabelGuard {
    std::bitset<256> kept{}; ///< labels, in any plane, that may neither gain nor lose voxels
    ProtectedLabels uncarved{}; ///< whose voxels must not be carved further than they are

    [[nodiscard]] bool any() const { return kept.any() || uncarved.labels.any(); }
};

// How every engine puts bricks in place. These functions work on bytes and may be called on any
// thread.

/// The bricks that must be read first, sorted, each once: those that are put in place, and the
/// label bricks over coverage if some labels must not be carved.
/// @param bricks images, or differences, several of which may belong to one brick
[[nodiscard]] std::vector<BrickKey> bricksToRead(
    const std::vector<BrickImage>& bricks, const LabelGuard& guard);

/// Checks whether the guard allows the images to be put in place.
/// @param now the bricks that had to be read
/// @param then no key twice
/// Errors: SegmentLocked, SegmentProtected; their argument is the label.
[[nodiscard]] Result<void> checkGuard(const LabelGuard& guard, const std::vector<BrickImage>& now,
    const std::vector<BrickImage>& then);

/// What bricks hold after all differences were applied, sorted by key.
/// @param differences XOR images with their bytes
/// @param now the bricks that had to be read
[[nodiscard]] std::vector<BrickImage> laidOver(
    const std::vector<BrickImage>& differences, const std::vector<BrickImage>& now);

} // namespace core
