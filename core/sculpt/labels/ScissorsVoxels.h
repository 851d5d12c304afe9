// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"

#include <glm/glm.hpp>

namespace core {

struct LabelScissors;

/// Finds out, on the processor, which voxels of one label scissors would remove that erase it: by
/// rules 1 to 4 of LabelScissors.h, whatever the values of the voxels. So it is known what lies
/// under a curve without changing any voxel. The cost is linear in the voxels; with `fromSurface`,
/// a ray for each element under the curve and a bit for each voxel of the box around the label are
/// added. Any thread. Errors: Cancelled.
/// @param scissors only its frame, mask, outside and fromSurface count; it is sound (checkSound())
/// @param voxels all those of the label in a volume of @p size
[[nodiscard]] Result<VoxelRuns> chosenOf(const LabelScissors& scissors, const VoxelRuns& voxels,
    const glm::ivec3& size, const Progress& progress);

} // namespace core
