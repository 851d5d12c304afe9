// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/mesh/SurfaceMirror.h"
#include "core/refine/voxels/GreyBox.h"

#include <vector>

namespace core {

// Finds places of a surface that may need another look (seed B §4.3). They are reported, never
// changed. Any thread.

/// Marks, by vertex id, green and red vertices that lie farther than @p toleranceMm from the
/// boundary of the mask although yellow vertices next to them follow it. After the mask was
/// changed, these are the conflicts.
[[nodiscard]] std::vector<bool> offTheMask(
    const SurfaceMirror& surface, const BoundaryForce& boundary, double toleranceMm);

/// Marks, by vertex id, yellow vertices where the grey values show no edge: the change of grey
/// values across the surface, averaged over the neighbours, is less than a quarter of the median
/// over the surface.
/// @param reachMm distance that is examined on either side
[[nodiscard]] std::vector<bool> withoutAnEdge(
    const SurfaceMirror& surface, const GreyBox& grey, double reachMm);

} // namespace core
