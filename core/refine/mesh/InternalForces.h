// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"

namespace core {

// What holds a simplex mesh together (Delingette 1999): a vertex is wanted above the middle of its
// three neighbours (metric parameters 1/3), so high that the mean curvature there is what it is
// around. The heights are those of the sphere through the vertex and its neighbours; the simplex
// angle itself is not needed, nor any function but the square root.

struct SimplexFrame {
    /// Outwards, of the plane of the three neighbours; 0: they lie in a line.
    glm::dvec3 normalLps{0.0};
    /// 1 / radius of the sphere through the vertex and its neighbours; positive where it bulges
    /// outwards, 0 where they lie in a plane.
    double curvaturePerMm = 0.0;
};
[[nodiscard]] SimplexFrame frameAt(const SimplexMesh& mesh, VertexId id);

/// The way from a vertex to where it is wanted.
/// @param curvaturePerMm what the curvature is to be; bounded by what the neighbours allow. That of
/// frameAt() moves it within its sphere only.
[[nodiscard]] glm::dvec3 internalForceMm(
    const SimplexMesh& mesh, VertexId id, double curvaturePerMm);

} // namespace core
