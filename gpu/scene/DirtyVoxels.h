// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/volume/VolumeGeometry.h"
#include "gpu/scene/Scene.h"
#include "gpu/scene/WorldBox.h"

namespace gpu {

/// Boxes of voxels that have changed since a picture was drawn, by field.
struct DirtyVoxels {
    core::VoxelBox labels;
    core::VoxelBox radiation;
    core::VoxelBox segmentation;
    core::VoxelBox pieces;
    core::VoxelBox barriers;
    core::VoxelBox barrierBricks;
    core::VoxelBox cutPreview;
    [[nodiscard]] bool empty() const;
};

/// Whether a scene shows anything of what changed. A slice does if its plane passes through the
/// changed voxels or their neighbours, or its slab through what was carved, where that is a hole.
[[nodiscard]] bool showsChange(
    const Scene& scene, const core::VolumeGeometry& geometry, const DirtyVoxels& dirty);
/// Whether a scene asks for cubic interpolation of anything.
[[nodiscard]] bool wantsCubics(const Scene& scene);
/// Whether a scene shows a part of the surface that is being refined within a box.
[[nodiscard]] bool showsSurface(const Scene& scene, const WorldBox& box);

} // namespace gpu
