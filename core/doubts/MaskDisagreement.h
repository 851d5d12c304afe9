// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"
#include "core/volume/VolumeGeometry.h"

#include <vector>

namespace core {

/// A part of one mask that another mask does not contain.
struct LonePart {
    VoxelRuns core; ///< its voxels whose neighbours all lie in the difference, too
    std::int64_t voxels = 0; ///< number of its voxels, the outer layer included
};

/// The parts of a mask that another mask does not contain, the largest first.
///
/// Two masks of one organ differ in a thin skin all around it, which is not worth a look. Therefore
/// a part must have a core: voxels of the difference whose six neighbours all lie in the
/// difference, too. A part is a connected set of core voxels (26 neighbours), together with the
/// voxels of the difference that share a face with one of them. Neighbours along an axis whose
/// spacing is at least twice the finest one do not count, because there a part may be a single
/// slice thick without being a skin. All in whole numbers. Cost ∝ the difference. Any thread.
/// Errors: Cancelled.
[[nodiscard]] Result<std::vector<LonePart>> onlyIn(const VoxelRuns& mask, const VoxelRuns& other,
    const VolumeGeometry& geometry, const Progress& progress);

} // namespace core
