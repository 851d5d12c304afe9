// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"
#include "tests/support/scenes/TestVolumes.h"

namespace test {

struct TriangleSurface {
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles;
};

/// An icosahedron, each of whose triangles is cut in four @p cuts times; its points lie on the
/// sphere around the origin.
[[nodiscard]] TriangleSurface icosphere(double radius, int cuts);
/// A torus around the z axis, ring by ring.
[[nodiscard]] TriangleSurface torus(double radius, double thickness, int around, int across);
[[nodiscard]] TriangleSurface moved(TriangleSurface surface, const glm::dvec3& by);
/// Both surfaces in one.
[[nodiscard]] TriangleSurface together(TriangleSurface one, const TriangleSurface& other);

/// The simplex mesh that is dual to a triangle surface; ends the program if there is none.
[[nodiscard]] core::SimplexMesh simplexMesh(const TriangleSurface& surface);
/// A simplex mesh whose vertices lie on the sphere around the origin.
[[nodiscard]] core::SimplexMesh simplexSphere(double radius, int cuts);

/// The Euler characteristic of each component, ascending; empty if the mesh is invalid.
[[nodiscard]] std::vector<int> eulerCharacteristics(const core::SimplexMesh& mesh);

/// Tries a random merge, split or swap.
/// @return whether it was accepted
bool randomOperation(core::SimplexMeshEdit& edit, Random& random);

} // namespace test
