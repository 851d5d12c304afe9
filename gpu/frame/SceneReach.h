// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/volume/VolumeGeometry.h"
#include "gpu/frame/Scene.h"
#include "gpu/frame/WorldBox.h"

namespace gpu {

/// Whether a slice's plane passes through these voxels or their neighbours.
[[nodiscard]] bool meetsPlane(
    const SliceScene& scene, const core::VolumeGeometry& geometry, const core::VoxelBox& voxels);
/// Whether a scene shows the surface that is being refined, and something of it in a box.
[[nodiscard]] bool showsSurface(const Scene& scene, const WorldBox& box);

} // namespace gpu
