// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "core/session/surface/SurfaceState.h"

#include <memory>
#include <vector>

namespace core {

/// What became of a surface since it was laid. It is read off the history whenever it is asked for,
/// so undo, branches and a session that was opened again all tell the same.
struct SurfacePast {
    enum class What {
        Deformed, ///< or marked
        Followed, ///< FollowMask
        WrittenBack,
    };
    struct Row {
        What what = What::Deformed;
        std::shared_ptr<const SurfaceStep> step; ///< null: the mesh stayed as it was
    };
    std::vector<Row> rows; ///< newest first, down to the first one after it was laid
};
/// Of the surface at the position of the history.
[[nodiscard]] SurfacePast surfacePast(const History& history, const SurfaceState& surface);

/// The voxels that a surface encloses (SurfaceVoxels.h), and those that it enclosed when it last
/// agreed with its mask.
///
/// Surface and mask agree when the surface is laid, and when it is written back. Where the surface
/// follows the mask over a voxel, they agree on that voxel from then on; on the others that changes
/// nothing. It follows the mask by FollowMask, and where it is yellow during strokes
/// (FollowedVoxels.h).
struct EnclosedVoxels {
    VoxelRuns now;
    VoxelRuns agreed;
    /// As if it had not been written back since it was laid; empty: nobody asked for it.
    VoxelRuns laid;
};
/// Goes back over the past on a copy of the mesh. Cost: a voxelisation for each row that moved
/// anything yellow, or at which the two agreed.
/// Errors: those of voxelsOf(); Internal where the past is not that of this mesh.
[[nodiscard]] Result<EnclosedVoxels> enclosedVoxels(const SimplexMesh& mesh,
    const SurfacePast& past, const VolumeGeometry& geometry, bool sinceLaid);

} // namespace core
