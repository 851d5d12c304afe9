// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/mesh/SurfaceMirror.h"
#include "core/refine/voxels/GreyBox.h"

#include <vector>

namespace core {

// Where a second look at a surface may pay (seed B §4.3): told, never applied. Any thread.

/// What stands off the boundary of the mask although yellow beside it follows that: green and red
/// that lie farther from it than @p toleranceMm, by vertex id. After the mask has changed, these
/// are the conflicts.
[[nodiscard]] std::vector<bool> offTheMask(
    const SurfaceMirror& surface, const BoundaryForce& boundary, double toleranceMm);

/// What follows the mask where grey values show no edge: yellow whose change of grey values across
/// the surface, evened out over the neighbours, is less than a quarter of what half of the surface
/// has, by vertex id. @param reachMm so far to either side
[[nodiscard]] std::vector<bool> withoutAnEdge(
    const SurfaceMirror& surface, const GreyBox& grey, double reachMm);

} // namespace core
