// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/cut/GrowthCut.h"

#include <span>

namespace core {

/// What a cut would remove, brick by brick, computed from the seed words alone, before the label
/// plane has been read.
struct LeavingBricks {
    struct Brick {
        std::uint32_t brick = 0;
        /// 4096: the label that would leave if the plane holds it there; 0: none
        std::vector<std::uint8_t> labels;
    };
    std::int64_t members = 0; ///< members that would leave the growth
    std::vector<Brick> bricks; ///< ascending by number
};

/// Finds them by the rules of GrowthCut.h. Errors and cost are those of cutGrowth().
[[nodiscard]] Result<LeavingBricks> leavingBricks(
    const WordBricks& words, const CutGrowth& command);

/// Compares them with the plane.
/// @param held the plane's labels in each of these bricks, in their order; an empty vector: all 0
[[nodiscard]] CutPreview cutPreview(
    const LeavingBricks& leaving, std::span<const std::vector<std::uint8_t>> held);

} // namespace core
