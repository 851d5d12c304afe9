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

/// Triangles around what is inside, in voxel indices: whole numbers of 2⁻¹⁴ of one.
struct LatticeSurface {
    static constexpr int bits = 14;
    std::vector<glm::ivec3> vertices;
    std::vector<glm::uvec3> triangles;
};
/// Rounded; what lies farther out than 32768 voxels is brought to there.
[[nodiscard]] glm::ivec3 latticePoint(const glm::dvec3& index);

/// How the triangles of a surface hang together; by the places of their corners, so that a file
/// that has them several times does as well.
enum class SurfaceKind {
    Closed, ///< along each edge as many triangles one way as the other
    TwoFaced, ///< closed, but triangles do not all look outwards
    Open, ///< an edge has an odd number of triangles: there is no inside
};
[[nodiscard]] SurfaceKind kindOf(const LatticeSurface& surface);

/// The voxels whose centres are inside, found by rays along the rows: of a Closed surface where it
/// goes around a centre, however often; else where an odd number of triangles lies on either side.
/// A centre on a triangle is inside where the inside lies on the side of greater column, then row,
/// then slice. All in whole numbers.
/// Errors: Cancelled; OutOfMemory where rays meet more triangles than can be kept.
[[nodiscard]] Result<VoxelRuns> fillSurface(const LatticeSurface& surface, SurfaceKind kind,
    const glm::ivec3& size, const Progress& progress);

} // namespace core
