// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/refine/mesh/SimplexMesh.h"
#include "core/refine/voxels/BoxMask.h"
#include "core/volume/VolumeGeometry.h"

namespace core {

/// Between these a surface gets as many vertices as its mask takes (MeasuredFit.h): fewer would be
/// too coarse for the tools, and to lay more takes more than half a minute on two cores.
constexpr int leastVertices = 10'000;
constexpr int mostVertices = 200'000;

/// A first simplex mesh around a mask, with about @p vertices of them: the dual of the voxels'
/// borders, on a lattice so much finer than the voxels as it takes, then with faces merged where
/// that leaves the surface as it runs. Every part, hole and handle of the mask is there, single
/// voxels and sheets of one voxel too, so there may be more vertices than asked for; voxels that
/// touch at an edge or a corner alone are kept apart. A grid too large for that many is what bounds
/// it below. Errors: Cancelled; Internal.
[[nodiscard]] Result<SimplexMesh> refineSurfaceOf(
    const BoxMask& mask, const VolumeGeometry& geometry, int vertices, const Progress& progress);

} // namespace core
