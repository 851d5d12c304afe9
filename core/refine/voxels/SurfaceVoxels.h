// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"
#include "core/refine/mesh/SimplexMesh.h"
#include "core/refine/voxels/SurfaceFill.h"
#include "core/volume/VolumeGeometry.h"

namespace core {

/// The triangles of a mesh, rounded to the lattice on which integers decide voxels; point numbers
/// are those of trianglesOf().
[[nodiscard]] LatticeSurface onLattice(const SimplexMesh& mesh, const VolumeGeometry& geometry);

/// The voxels whose centres are inside (SurfaceFill.h). Errors: those of fillSurface().
[[nodiscard]] Result<VoxelRuns> voxelsOf(
    const SimplexMesh& mesh, const VolumeGeometry& geometry, const Progress& progress);

} // namespace core
