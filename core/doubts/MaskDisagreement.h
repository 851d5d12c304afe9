// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"
#include "core/volume/VolumeGeometry.h"

#include <vector>

namespace core {

/// A part of one mask that another one does not have.
struct LonePart {
    VoxelRuns core; ///< of it, the voxels all of whose neighbours are the part's, too
    std::int64_t voxels = 0; ///< with its outer layer
};

/// The parts of a mask that another mask does not have, the largest first.
///
/// Two masks of one organ differ in a thin skin all around, which is no place to go to. So a part
/// has a core: voxels of which all neighbours (six) are in the difference, too. It is what hangs
/// together of such voxels, and what lies beside them. Across slices that are at least twice as far
/// apart as voxels in them, neighbours are not asked: there one slice is no thin skin. Whole
/// numbers only. Cost ∝ the difference. Any thread. Errors: Cancelled.
[[nodiscard]] Result<std::vector<LonePart>> onlyIn(const VoxelRuns& mask, const VoxelRuns& other,
    const VolumeGeometry& geometry, const Progress& progress);

} // namespace core
