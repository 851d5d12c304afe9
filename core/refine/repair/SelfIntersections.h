// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"
#include "core/refine/repair/CrossingFaces.h"
#include "core/volume/VolumeGeometry.h"

namespace core {

/// Finds where a surface passes through itself. Its triangles (SimplexDual.h) are rounded to the
/// lattice on which they decide voxels (SurfaceVoxels.h), and all computation is in integers. Faces
/// that only touch do not count. Ascending; independent of the number of threads.
[[nodiscard]] std::vector<CrossingFaces> selfIntersections(
    const SimplexMesh& mesh, const VolumeGeometry& geometry);

/// The result of a repair.
struct IntersectionRepair {
    std::size_t before = 0; ///< pairs of faces
    std::size_t left = 0; ///< pairs that could not be repaired
    int rounds = 0;
};
/// Repairs them: around such faces vertices move towards the middle of their neighbours, and sheets
/// that face each other move apart, in a region that grows until no intersection is left or @p
/// mostRounds rounds are done. Green vertices stay. To be used before the surface is written back.
IntersectionRepair repairSelfIntersections(
    SimplexMeshEdit& edit, const VolumeGeometry& geometry, int mostRounds = 40);

} // namespace core
