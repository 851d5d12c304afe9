// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// The connected parts of a set of voxels (26 neighbours), in the order of their first voxels in
/// memory. Cost ∝ the runs of the set and the rows of the volume. Any thread outside a
/// parallelFor(). Errors: Cancelled.
/// @param size of the volume
/// @param least parts of fewer voxels are left out
[[nodiscard]] Result<std::vector<VoxelRuns>> islandsOf(
    const VoxelRuns& voxels, const glm::ivec3& size, std::int64_t least, const Progress& progress);

} // namespace core
