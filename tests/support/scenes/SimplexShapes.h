// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"
#include "tests/support/scenes/TestVolumes.h"

namespace test {

struct TriangleSurface {
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles;
};

/// An icosahedron, each triangle cut in four so many times; points on the sphere around the origin.
[[nodiscard]] TriangleSurface icosphere(double radius, int cuts);
/// Around the z axis; ring by ring.
[[nodiscard]] TriangleSurface torus(double radius, double thickness, int around, int across);
[[nodiscard]] TriangleSurface moved(TriangleSurface surface, const glm::dvec3& by);
/// Both side by side.
[[nodiscard]] TriangleSurface together(TriangleSurface one, const TriangleSurface& other);

/// The dual; ends the program if there is none.
[[nodiscard]] core::SimplexMesh simplexMesh(const TriangleSurface& surface);
/// A simplex mesh whose vertices lie on the sphere around the origin.
[[nodiscard]] core::SimplexMesh simplexSphere(double radius, int cuts);

/// χ of each component, ascending; empty if the mesh is broken.
[[nodiscard]] std::vector<int> eulerCharacteristics(const core::SimplexMesh& mesh);

/// A merge, a split or a swap somewhere; true: it was not refused.
bool randomOperation(core::SimplexMeshEdit& edit, Random& random);

} // namespace test
