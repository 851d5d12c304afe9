// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

namespace core {

/// What a step may have touched: the voxels and seeds of a segment, or anything in a box.
struct Touch {
    int segment = 0; ///< label; 0: the box counts
    VoxelBox box{}; ///< index space
};

} // namespace core
