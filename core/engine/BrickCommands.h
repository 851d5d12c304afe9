// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/engine/LabelGuard.h"

#include <cstdint>
#include <vector>

namespace core {

// Commands that replace, change or read whole bricks.

/// Replaces the contents of bricks by these images (undo, redo, opening a session). Each key occurs
/// once. The result lists the bricks that differ, with statistics, as for EndEdit. If the guard
/// does not allow the change, the command is refused with SegmentLocked or SegmentProtected and the
/// label.
struct SwapBricks {
    std::vector<BrickImage> bricks;
    LabelGuard guard{};
};
/// Applies differences to the contents of bricks (undo, redo, "undo only here"). A brick may occur
/// several times. The result is that of SwapBricks.
struct XorBricks {
    std::vector<BrickImage> differences; ///< XOR images, each with its bytes
    LabelGuard guard{};
};
/// Reads bricks; the result lists each with `after` filled and `before` empty, in this order.
struct ReadBricks {
    std::vector<BrickKey> keys;
};
/// Reads the bricks of seed words in which a label plane holds barriers; the result is that of
/// ReadBricks, ascending. Cost ∝ these bricks, and those that were written since barriers were last
/// looked for.
struct ReadBarriers {
    std::uint8_t plane = 0;
};

} // namespace core
