// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/brick/VoxelRuns.h"

#include <cstdint>
#include <span>

namespace core {

/// The smallest box that contains all voxels of a label, in indices; empty if there is none. Cost:
/// one pass over the volume.
/// @param labels one for each voxel of the volume, x fastest
[[nodiscard]] VoxelBox boxOfLabel(
    std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label);

/// The same for voxels given as runs. Cost: proportional to the number of runs.
/// @param size of the volume in which they lie
[[nodiscard]] VoxelBox boxOfRuns(const VoxelRuns& voxels, const glm::ivec3& size);

} // namespace core
