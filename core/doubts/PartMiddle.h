// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/volume/VolumeGeometry.h"

namespace core {

/// The spacing of voxels in whole micrometres, at least 1, for decisions that must be the same on
/// every machine.
[[nodiscard]] glm::i64vec3 spacingUm(const VolumeGeometry& geometry);

/// The voxel with a given index in memory, x fastest.
[[nodiscard]] glm::ivec3 voxelOf(std::uint64_t number, const glm::ivec3& size);

/// The voxel of the set that lies nearest to the set's centroid; if several are equally near, the
/// one with the lowest index in memory.
/// @pre the set is not empty
[[nodiscard]] glm::ivec3 middleOf(const VoxelRuns& voxels, const VolumeGeometry& geometry);

} // namespace core
