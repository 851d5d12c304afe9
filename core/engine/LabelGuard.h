// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"

#include <bitset>
#include <cstdint>
#include <vector>

namespace core {

/// Which labels must not be touched where bricks are put in place whole: a step of the past knows
/// nothing of segments that were locked or protected since.
struct LabelGuard {
    std::bitset<256> kept{}; ///< no voxel of these may come or go, in whatever plane
    std::uint8_t plane = 0; ///< of the labels below
    std::bitset<256> uncarved{}; ///< voxels of these may be carved no further than they are

    [[nodiscard]] bool any() const { return kept.any() || uncarved.any(); }
};

// How every engine puts bricks in place, worked out in bytes. Any thread.

/// The bricks that have to be read for it, sorted, each once: those that are put in place, and the
/// labels over coverage where some must not be carved.
/// @param bricks images, or differences, of which a brick may have several
[[nodiscard]] std::vector<BrickKey> bricksToRead(
    const std::vector<BrickImage>& bricks, const LabelGuard& guard);

/// Whether the guard lets images be put in place.
/// @param now the bricks that had to be read @param then no key twice
/// Errors: SegmentLocked, SegmentProtected; their argument is the label.
[[nodiscard]] Result<void> checkGuard(const LabelGuard& guard, const std::vector<BrickImage>& now,
    const std::vector<BrickImage>& then);

/// What bricks hold once all differences are laid over them, sorted by key.
/// @param now the bricks that had to be read @param differences XOR images with their bytes
[[nodiscard]] std::vector<BrickImage> laidOver(
    const std::vector<BrickImage>& differences, const std::vector<BrickImage>& now);

} // namespace core
