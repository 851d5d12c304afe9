// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/refine/mesh/SimplexMesh.h"
#include "core/volume/VolumeGeometry.h"

namespace core {

/// Merges the smallest face of a mesh with a neighbour, repeatedly, until at most @p vertices
/// vertices are left. These stay in place and get new ids without gaps. Faces that meet at an angle
/// are not merged, nor are those at a green vertex, nor any into a face far larger than the mean,
/// so more vertices may be left. Errors: Cancelled.
/// @param apartOn no merge is made that would let faces pass through each other that did not
/// before, on the lattice of this grid (CrossingGuard.h); null: this is not checked
[[nodiscard]] Result<SimplexMesh> thinnedOut(SimplexMesh mesh, std::size_t vertices,
    const Progress& progress, const VolumeGeometry* apartOn = nullptr);

} // namespace core
