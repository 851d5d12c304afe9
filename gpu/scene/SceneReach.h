// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/volume/VolumeGeometry.h"
#include "gpu/scene/Scene.h"
#include "gpu/scene/WorldBox.h"

namespace gpu {

/// Voxels whose fields are other than they were drawn.
struct DirtyVoxels {
    core::VoxelBox labels;
    core::VoxelBox radiation;
    core::VoxelBox segmentation;
    core::VoxelBox pieces;
    core::VoxelBox barriers;
    core::VoxelBox barrierBricks;
    core::VoxelBox foreseen;
    [[nodiscard]] bool empty() const;
};

/// Whether a scene shows anything of what changed: a slice where its plane passes through it or its
/// neighbours.
[[nodiscard]] bool showsChange(
    const Scene& scene, const core::VolumeGeometry& geometry, const DirtyVoxels& dirty);
/// Whether a scene wants something of it interpolated by cubics.
[[nodiscard]] bool wantsCubics(const Scene& scene);
/// Whether a scene shows the surface that is being refined, and something of it in a box.
[[nodiscard]] bool showsSurface(const Scene& scene, const WorldBox& box);

} // namespace gpu
