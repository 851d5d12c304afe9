// SPDX-License-Identifier: Apache-2.0
#include "core/refine/voxels/SurfaceVoxels.h"

#include "core/refine/mesh/SimplexDual.h"
#include "core/volume/WorldToIndex.h"

namespace core {

LatticeSurface onLattice(const SimplexMesh& mesh, const VolumeGeometry& geometry)
{
    SimplexTriangles triangles = trianglesOf(mesh);
    const WorldToIndex toIndex(geometry);
    LatticeSurface surface;
    surface.vertices.reserve(triangles.pointsLps.size());
    for (const glm::dvec3& point : triangles.pointsLps)
        surface.vertices.push_back(latticePoint(toIndex(point)));
    surface.triangles = std::move(triangles.triangles);
    return surface;
}

Result<VoxelRuns> voxelsOf(
    const SimplexMesh& mesh, const VolumeGeometry& geometry, const Progress& progress)
{
    return fillSurface(onLattice(mesh, geometry), SurfaceKind::Closed, geometry.size, progress);
}

} // namespace core
