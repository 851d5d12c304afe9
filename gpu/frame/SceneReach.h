// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/volume/VolumeGeometry.h"
#include "gpu/frame/Scene.h"

namespace gpu {

/// Whether a slice's plane passes through these voxels or their neighbours.
[[nodiscard]] bool meetsPlane(
    const SliceScene& scene, const core::VolumeGeometry& geometry, const core::VoxelBox& voxels);

} // namespace gpu
