// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/meshfile/MeshWriter.h"
#include "core/refine/mesh/SimplexMesh.h"

namespace core {

/// A surface as it goes into a file: its triangles, those of each face around the face's middle.
/// The caller names and colours it. @param turn 1, or −1 along axes that are turned round
[[nodiscard]] MeshPart partOf(const SimplexMesh& mesh, const glm::dvec3& turn = glm::dvec3(1.0));

} // namespace core
