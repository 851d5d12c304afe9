// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "core/session/surface/SurfaceState.h"

#include <memory>
#include <vector>

namespace core {

/// What happened to a surface since it was laid. It is read from the history each time, so it is
/// the same after undo, on a branch, and in a session that was opened again.
struct SurfacePast {
    enum class What {
        Deformed, ///< or marked
        Followed, ///< FollowMask
        WrittenBack, ///< without an editable range that leaves voxels out
    };
    struct Row {
        What what = What::Deformed;
        std::shared_ptr<const SurfaceStep> step; ///< null: the mesh did not change
    };
    std::vector<Row> rows; ///< newest first, back to the first one after the surface was laid
};
/// That of the surface at the position of the history.
[[nodiscard]] SurfacePast surfacePast(const History& history, const SurfaceState& surface);

/// The voxels that a surface encloses (SurfaceVoxels.h), and those that it enclosed when it last
/// agreed with its mask.
///
/// Surface and mask agree when the surface is laid and when it is written back, unless that kept to
/// an editable range. When the surface
/// follows the mask over a voxel, they agree on that voxel from then on, and nothing changes for
/// the others. It follows the mask by FollowMask, and during strokes where it is yellow
/// (FollowedVoxels.h).
struct EnclosedVoxels {
    VoxelRuns now;
    VoxelRuns agreed;
    /// As `agreed`, as if it had not been written back since it was laid; empty: not requested.
    VoxelRuns laid;
};
/// Goes back through the past on a copy of the mesh. Cost: one voxelisation for each row that moved
/// yellow parts or at which the two agreed. Errors: those of voxelsOf(); Internal if the past does
/// not belong to this mesh.
[[nodiscard]] Result<EnclosedVoxels> enclosedVoxels(const SimplexMesh& mesh,
    const SurfacePast& past, const VolumeGeometry& geometry, bool sinceLaid);

} // namespace core
