// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/mesh/SimplexMeshEdit.h"

namespace core {

/// Pulls all yellow vertices to the boundary of a mask and adapts the structure to the shape; red
/// and green vertices stay. Where no boundary is found within the search distance, a vertex stays.
/// It takes about as long as the first fit.
/// @param apartOn as in SurfaceStrokeSettings
/// Errors: Cancelled; the edit is then to be rolled back.
[[nodiscard]] Result<void> followBoundary(SimplexMeshEdit& edit, const BoundaryForce& boundary,
    const Progress& progress, const VolumeGeometry* apartOn = nullptr);

} // namespace core
