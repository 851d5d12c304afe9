// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/volume/VolumeGeometry.h"

#include <vector>

namespace core {

/// The centres, in LPS mm, of the voxels that have one of their six neighbours outside the mask or
/// outside the volume; ascending, x fastest. Cost ∝ the mask's voxels.
[[nodiscard]] std::vector<glm::dvec3> borderVoxels(
    const VoxelRuns& mask, const VolumeGeometry& geometry);

} // namespace core
