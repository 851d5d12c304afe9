// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/meshfile/MeshWriter.h"
#include "core/refine/mesh/SimplexMesh.h"

namespace core {

/// A surface as it is written to a file: its triangles, those of each face around the middle of the
/// face. The caller adds name and colour.
/// @param turn factor for each axis: 1, or −1 to reverse it
[[nodiscard]] MeshPart partOf(const SimplexMesh& mesh, const glm::dvec3& turn = glm::dvec3(1.0));

} // namespace core
