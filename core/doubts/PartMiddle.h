// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/volume/VolumeGeometry.h"

namespace core {

/// The sides of a voxel in whole micrometres, for decisions that are the same on every machine.
[[nodiscard]] glm::i64vec3 spacingUm(const VolumeGeometry& geometry);

/// The voxel with a number, x fastest.
[[nodiscard]] glm::ivec3 voxelOf(std::uint64_t number, const glm::ivec3& size);

/// That one of some voxels which is nearest to their centre, the first of equal ones.
/// @pre there are voxels
[[nodiscard]] glm::ivec3 middleOf(const VoxelRuns& voxels, const VolumeGeometry& geometry);

} // namespace core
