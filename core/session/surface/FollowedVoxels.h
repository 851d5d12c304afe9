// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/refine/mesh/SimplexMeshDelta.h"
#include "core/volume/VolumeGeometry.h"

namespace core {

// Yellow parts of a surface follow the mask, during strokes, too: where a stroke passes by they
// come nearer to the mask than they were laid, also far from the tool. That is no wish of the
// user's, so it must not be written back: it is told apart here from what the tool moved. Tools
// leave red or green what they moved.

/// Whether a change moved a vertex that is yellow then.
[[nodiscard]] bool movesYellow(const SimplexMeshDelta& change);

/// Of the voxels that a surface was moved over by a change, those that its yellow parts alone were
/// moved over.
///
/// The tool's are those in the box around a face that the change moved and that has a vertex of
/// another colour, and all that hang together with these by the 26 around them; but none that is in
/// boxes of faces that are all yellow only. Boxes are in voxels, of the vertices rounded to the
/// lattice of SurfaceFill, so that whole numbers decide.
/// @param after the surface after the change
[[nodiscard]] VoxelRuns followedVoxels(const VoxelRuns& moved, const SimplexMesh& after,
    const SimplexMeshDelta& change, const VolumeGeometry& geometry);

} // namespace core
