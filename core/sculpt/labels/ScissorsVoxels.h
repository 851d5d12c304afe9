// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"

#include <glm/glm.hpp>

namespace core {

struct LabelScissors;

/// Of the voxels of one label those that scissors choose which remove it: rules 1 to 4 of
/// LabelScissors.h, for voxels of any value, on the processor. So it is known what lies under a
/// curve without a change of any voxel. Cost: that of the voxels, and with `fromSurface` that of a
/// ray for each element under the curve and of a bit for each voxel of the box around the label.
/// Any thread. Errors: Cancelled.
/// @param scissors only its frame, mask, outside and fromSurface count; it is sound (checkSound())
/// @param voxels all those of the label in a volume of @p size
[[nodiscard]] Result<VoxelRuns> chosenOf(const LabelScissors& scissors, const VoxelRuns& voxels,
    const glm::ivec3& size, const Progress& progress);

} // namespace core
