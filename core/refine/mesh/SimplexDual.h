// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"

namespace core {

/// The simplex mesh that is dual to a surface of triangles: a vertex in the middle of each
/// triangle, a face around each corner; points that no triangle names are left out. Triangles turn
/// to the left seen from outside. Errors: Internal (argument 0: where it is not closed or not
/// manifold).
[[nodiscard]] Result<SimplexMesh> dualOf(
    std::span<const glm::dvec3> pointsLps, std::span<const glm::uvec3> triangles);

/// A simplex mesh as triangles: each face as a fan around the mean of its vertices. Closed, without
/// gaps; to the left seen from outside.
struct SimplexTriangles {
    /// By vertex id, then the faces' middles, by vertexSlots() + face id. What does not exist lies
    /// at the origin, and no triangle names it.
    std::vector<glm::dvec3> pointsLps;
    std::vector<glm::uvec3> triangles; ///< ordered by face: (vertex, vertex, middle)
    std::vector<FaceId> faces; ///< of each triangle
};
[[nodiscard]] SimplexTriangles trianglesOf(const SimplexMesh& mesh);

/// What a mesh encloses, by those triangles.
[[nodiscard]] double enclosedMm3(const SimplexMesh& mesh);

/// The mean of a ring's vertices.
[[nodiscard]] glm::dvec3 middleOf(const SimplexMesh& mesh, FaceId face);

} // namespace core
