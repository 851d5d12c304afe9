// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/cut/GrowthCut.h"

#include <span>

namespace core {

/// What a cut would take of the plane, brick by brick, before it is known what the plane holds.
struct LeavingBricks {
    struct Brick {
        std::uint32_t brick = 0;
        std::vector<std::uint8_t> labels; ///< 4096; leaves where the plane holds it; 0: none does
    };
    std::int64_t members = 0; ///< that leave
    std::vector<Brick> bricks; ///< ascending
};

/// By the rules of GrowthCut.h, refused like the cut. Cost like that of the cut itself.
[[nodiscard]] Result<LeavingBricks> leavingBricks(
    const WordBricks& words, const CutGrowth& command);

/// @param held what the plane holds in each of these bricks; no bytes: nothing
[[nodiscard]] ForeseenCut foreseenCut(
    const LeavingBricks& leaving, std::span<const std::vector<std::uint8_t>> held);

} // namespace core
