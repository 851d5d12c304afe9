// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

namespace core {

/// A place or a segment for which the step that last changed it is searched: the voxels and seeds
/// of a segment, or anything in a box.
struct Touch {
    int segment = 0; ///< label; 0: use the box
    VoxelBox box{}; ///< in voxels
};

} // namespace core
