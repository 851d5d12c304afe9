// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/engine/LabelGuard.h"

#include <vector>

namespace core {

// Commands that put whole bricks in place, or read them.

/// Puts these images in place of the contents of bricks (undo, redo, opening a session). Each key
/// occurs once. The result lists the bricks that differ, with statistics, as for EndEdit. If the
/// guard does not allow it, it is refused with SegmentLocked or SegmentProtected and the label.
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

} // namespace core
