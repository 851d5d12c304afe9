// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/deform/RefineSurface.h"

namespace core {

struct InitialFitSettings {
    int vertices = 12'000; ///< about; see refineSurfaceOf()
    int steps = 40; ///< of deformation, at most
    int restructureEvery = 5; ///< steps; 0: never
    bool mendsCrossings = true; ///< where the surface passes through itself
};

/// Draws a mesh that refineSurfaceOf() laid around a mask to the smooth boundary of it; see
/// initialFit().
[[nodiscard]] Result<void> fitToMask(SimplexMesh& mesh, const BoxMask& mask,
    const VolumeGeometry& geometry, const InitialFitSettings& settings, const Progress& progress);

/// A simplex mesh around a mask, all yellow, on its smooth boundary (SmoothOccupancy.h), without
/// self-intersections as far as they could be mended. Empty for an empty mask. Runs for seconds;
/// any thread. Errors: Cancelled; Internal.
[[nodiscard]] Result<SimplexMesh> initialFit(const BoxMask& mask, const VolumeGeometry& geometry,
    const InitialFitSettings& settings, const Progress& progress);

} // namespace core
