// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"
#include "core/volume/VolumeGeometry.h"

namespace core {

/// Two faces that pass through each other; twice the same: one that passes through itself.
struct CrossingFaces {
    FaceId one = noId; ///< not the greater
    FaceId other = noId;
    bool operator==(const CrossingFaces&) const = default;
    auto operator<=>(const CrossingFaces&) const = default;
};

/// Where a surface passes through itself: of its triangles (SimplexDual.h), rounded to the lattice
/// on which they decide voxels (SurfaceVoxels.h), in whole numbers. To touch is not to pass
/// through. Ascending; independent of the number of threads.
[[nodiscard]] std::vector<CrossingFaces> selfIntersections(
    const SimplexMesh& mesh, const VolumeGeometry& geometry);

struct IntersectionRepair {
    std::size_t before = 0; ///< pairs of faces
    std::size_t left = 0; ///< that could not be mended
    int rounds = 0;
};
/// Mends it: around such faces vertices move towards the middle of their neighbours, and sheets
/// that face each other away from one another, in a region that grows until the surface is free of
/// them or @p mostRounds are over. Green vertices stay. For before the surface is written back.
IntersectionRepair repairSelfIntersections(
    SimplexMeshEdit& edit, const VolumeGeometry& geometry, int mostRounds = 40);

} // namespace core
