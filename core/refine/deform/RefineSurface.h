// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/refine/mesh/SimplexMesh.h"
#include "core/refine/voxels/BoxMask.h"
#include "core/volume/VolumeGeometry.h"

namespace core {

/// Limits for the number of vertices that is chosen automatically (MeasuredFit.h): fewer would be
/// too coarse for the tools, and with more laying would take too long to wait for.
constexpr int leastVertices = 10'000;
constexpr int mostVertices = 400'000;
/// The most for surfaces that were laid by older rules (edits/kinds/surface/parts/SurfaceRules.h).
constexpr int mostVerticesOnce = 200'000;

/// Makes a first simplex mesh around a mask, with about @p vertices vertices: the dual of the voxel
/// borders, on a lattice as much finer than the voxels as necessary, whose faces are then merged
/// where that does not change the shape. Every part, hole and handle of the mask is kept, including
/// single voxels and sheets of one voxel, so there may be more vertices than requested. Voxels that
/// touch only at an edge or a corner are kept apart. A grid too large for that number limits how
/// coarse the mesh can be. Errors: Cancelled; Internal.
[[nodiscard]] Result<SimplexMesh> refineSurfaceOf(
    const BoxMask& mask, const VolumeGeometry& geometry, int vertices, const Progress& progress);

/// The same, but along the borders of the voxels as they are, without smoothing and without a finer
/// lattice: a surface as jagged as its voxels, which never passes through itself
/// (refine/README.md).
[[nodiscard]] Result<SimplexMesh> borderSurfaceOf(
    const BoxMask& mask, const VolumeGeometry& geometry, int vertices, const Progress& progress);

} // namespace core
