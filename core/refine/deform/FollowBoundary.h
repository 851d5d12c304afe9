// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/mesh/SimplexMeshEdit.h"

namespace core {

/// Draws all that is yellow to the boundary of a mask, with structure that follows the shape; red
/// and green vertices stay where they are. A boundary beyond its reach is not found, and the vertex
/// stays. About as long as the first fit.
void followBoundary(SimplexMeshEdit& edit, const BoundaryForce& boundary);

} // namespace core
