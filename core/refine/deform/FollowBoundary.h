// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/mesh/SimplexMeshEdit.h"

namespace core {

/// Pulls all yellow vertices to the boundary of a mask and adapts the structure to the shape; red
/// and green vertices stay. Where no boundary is found within the search distance, a vertex stays.
/// It takes about as long as the first fit.
void followBoundary(SimplexMeshEdit& edit, const BoundaryForce& boundary);

} // namespace core
