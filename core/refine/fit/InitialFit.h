// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/deform/RefineSurface.h"

namespace core {

/// Parameters of the first fit.
struct InitialFitSettings {
    int vertices = 12'000; ///< approximate; see refineSurfaceOf()
    int steps = 40; ///< greatest number of deformation steps
    int restructureEvery = 5; ///< steps; 0: never
    bool mendsCrossings = true; ///< repair places where the surface passes through itself
    /// Whether crossings are prevented in each step (CrossingGuard.h). Older rows were fitted
    /// without this.
    bool keepsApart = false;
};

/// Moves a mesh that refineSurfaceOf() laid around a mask to its smooth boundary; see initialFit().
[[nodiscard]] Result<void> fitToMask(SimplexMesh& mesh, const BoxMask& mask,
    const VolumeGeometry& geometry, const InitialFitSettings& settings, const Progress& progress);

/// Makes a simplex mesh around a mask, all yellow, on its smooth boundary (SmoothOccupancy.h).
/// Self-intersections are repaired as far as possible. Empty for an empty mask. Takes seconds; any
/// thread. Errors: Cancelled; Internal.
[[nodiscard]] Result<SimplexMesh> initialFit(const BoxMask& mask, const VolumeGeometry& geometry,
    const InitialFitSettings& settings, const Progress& progress);

} // namespace core
