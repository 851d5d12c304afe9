// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"

namespace core {

// Internal forces of a simplex mesh (Delingette 1999): a vertex is pulled to a point above the
// middle of its three neighbours (metric parameters 1/3), at the height for which its mean
// curvature equals that of its surroundings. Heights are computed from the sphere through the
// vertex and its neighbours; neither the simplex angle nor any function but the square root is
// needed.

/// The local shape of the surface at a vertex.
struct SimplexFrame {
    /// Outward normal of the plane of the three neighbours; 0 if they lie in a line.
    glm::dvec3 normalLps{0.0};
    /// 1 / radius of the sphere through the vertex and its neighbours; positive where the surface
    /// bulges outwards, 0 where they lie in a plane.
    double curvaturePerMm = 0.0;
};
[[nodiscard]] SimplexFrame frameAt(const SimplexMesh& mesh, VertexId id);

/// The vector from a vertex to where it should be.
/// @param curvaturePerMm the intended curvature; limited by what the neighbours allow. With that of
/// frameAt() the vertex moves only within its sphere.
[[nodiscard]] glm::dvec3 internalForceMm(
    const SimplexMesh& mesh, VertexId id, double curvaturePerMm);

} // namespace core
