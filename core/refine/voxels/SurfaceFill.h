// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// Triangles of a surface in voxel indices, as integers in units of 2⁻¹⁴ voxel.
struct LatticeSurface {
    static constexpr int bits = 14;
    std::vector<glm::ivec3> vertices;
    std::vector<glm::uvec3> triangles;
};
/// Rounds a point; coordinates are limited to ±32768 voxels.
[[nodiscard]] glm::ivec3 latticePoint(const glm::dvec3& index);

/// How the triangles of a surface are connected. Corners are compared by place, so a file may
/// contain the same corner several times.
enum class SurfaceKind {
    Closed, ///< along each edge, as many triangles run one way as the other
    TwoFaced, ///< closed, but not all triangles face outwards
    Open, ///< an edge has an odd number of triangles: there is no inside
};
[[nodiscard]] SurfaceKind kindOf(const LatticeSurface& surface);

/// The voxels whose centres are inside, found by rays along the rows. A Closed surface contains a
/// centre that it winds around, however often; otherwise a centre is inside if an odd number of
/// triangles lies on either side. A centre on a triangle is inside if the inside is on the side of
/// the greater column, then row, then slice. All computation is in integers. Errors: Cancelled;
/// OutOfMemory if the rays meet more triangles than can be stored.
[[nodiscard]] Result<VoxelRuns> fillSurface(const LatticeSurface& surface, SurfaceKind kind,
    const glm::ivec3& size, const Progress& progress);

} // namespace core
