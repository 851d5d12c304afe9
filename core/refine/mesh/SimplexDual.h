// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"

namespace core {

/// The simplex mesh that is dual to a surface of triangles: a vertex in the middle of each
/// triangle, and a face around each corner. Points that no triangle uses are left out. Triangles
/// are counter-clockwise seen from outside. Errors: Internal (argument 0: where the surface is not
/// closed or not manifold).
[[nodiscard]] Result<SimplexMesh> dualOf(
    std::span<const glm::dvec3> pointsLps, std::span<const glm::uvec3> triangles);

/// A simplex mesh as triangles: each face is a fan around the mean of its vertices. Closed, without
/// gaps; counter-clockwise seen from outside.
struct SimplexTriangles {
    /// By vertex id, then the middles of faces at vertexSlots() + face id. Entries of vertices and
    /// faces that do not exist are at the origin, and no triangle uses them.
    std::vector<glm::dvec3> pointsLps;
    std::vector<glm::uvec3> triangles; ///< ordered by face: (vertex, vertex, middle)
    std::vector<FaceId> faces; ///< of each triangle
};
[[nodiscard]] SimplexTriangles trianglesOf(const SimplexMesh& mesh);

/// The volume that a mesh encloses, computed from those triangles.
[[nodiscard]] double enclosedMm3(const SimplexMesh& mesh);

/// The mean of the vertices of a face.
[[nodiscard]] glm::dvec3 middleOf(const SimplexMesh& mesh, FaceId face);

} // namespace core
