// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/refine/mesh/SimplexMeshDelta.h"
#include "core/volume/VolumeGeometry.h"

namespace core {

// Separates what a tool moved from what followed the mask. The yellow parts of a surface follow the
// mask during strokes too: near a stroke they come closer to the mask than they were when the
// surface was laid, even far from the tool. The user did not ask for that, so it must not be
// written back. Tools leave what they moved red or green.

/// Whether a change moved a vertex that is yellow after it.
[[nodiscard]] bool movesYellow(const SimplexMeshDelta& change);

/// Of the voxels that a change moved the surface over, returns those that only yellow parts were
/// moved over.
///
/// The tool's voxels are those in the bounding box of a face that the change moved and that has a
/// vertex of another colour, and all voxels connected with these (26 neighbours), except those that
/// are only in boxes of faces that are entirely yellow. Boxes are in voxels, of vertices rounded to
/// the lattice of SurfaceFill, so that whole numbers decide. All other voxels are returned.
/// @param after the surface after the change
[[nodiscard]] VoxelRuns followedVoxels(const VoxelRuns& moved, const SimplexMesh& after,
    const SimplexMeshDelta& change, const VolumeGeometry& geometry);

} // namespace core
