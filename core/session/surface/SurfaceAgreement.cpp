// SPDX-License-Identifier: Apache-2.0
#include "core/session/surface/SurfaceAgreement.h"

#include "core/brick/VoxelRunSets.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/refine/mesh/SurfaceDelta.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "core/session/surface/FollowedVoxels.h"

#include <optional>
#include <utility>

namespace core {

namespace {

/// Where the surface followed the mask in one row.
struct Followed {
    VoxelRuns moved; ///< over these
    VoxelRuns inside; ///< those of them that it encloses after it
};

VoxelRuns afterFollowing(const VoxelRuns& agreed, const Followed& followed)
{
    return differing(agreed, differing(common(agreed, followed.moved), followed.inside));
}

/// @param newest the last of them counts first
VoxelRuns afterFollowing(VoxelRuns agreed, const std::vector<Followed>& newest)
{
    for (auto followed = newest.rbegin(); followed != newest.rend(); ++followed)
        agreed = afterFollowing(agreed, *followed);
    return agreed;
}

bool follows(const SurfacePast::Row& row)
{
    return row.what == SurfacePast::What::Followed
        || (row.what == SurfacePast::What::Deformed && row.step && movesYellow(row.step->mesh));
}

/// A surface on its way back.
class WayBack {
public:
    WayBack(const SimplexMesh& mesh, const VolumeGeometry& geometry)
        : m_mesh(mesh)
        , m_geometry(geometry)
    {
    }

    /// What it encloses where it is.
    Result<VoxelRuns> voxels()
    {
        if (!m_voxels) {
            Result<VoxelRuns> inside = voxelsOf(m_mesh, m_geometry, {});
            if (!inside)
                return inside;
            m_voxels = *std::move(inside);
        }
        return *m_voxels;
    }
    /// @return where it had followed the mask
    Result<Followed> goBack(const SurfacePast::Row& row)
    {
        if (!row.step || row.step->mesh.empty())
            return Followed();
        const SimplexMeshDelta& change = row.step->mesh;
        if (!canUndo(change, m_mesh))
            return failure(ErrorCode::Internal,
                Clause::saying("the surface does not go back to how it was laid"));
        if (!follows(row)) {
            change.undo(m_mesh);
            m_voxels.reset();
            return Followed();
        }
        const Result<VoxelRuns> after = voxels();
        if (!after)
            return tl::unexpected(after.error());
        const SimplexMesh moved = m_mesh;
        change.undo(m_mesh);
        m_voxels.reset();
        const Result<VoxelRuns> before = voxels();
        if (!before)
            return tl::unexpected(before.error());
        Followed followed{.moved = differing(*before, *after), .inside = {}};
        if (row.what == SurfacePast::What::Deformed)
            followed.moved = followedVoxels(followed.moved, moved, change, m_geometry);
        followed.inside = common(*after, followed.moved);
        return followed;
    }

private:
    SimplexMesh m_mesh;
    const VolumeGeometry& m_geometry;
    std::optional<VoxelRuns> m_voxels;
};

} // namespace

SurfacePast surfacePast(const History& history, const SurfaceState& surface)
{
    SurfacePast past;
    for (RowId id = history.position(); id != 0; id = history.row(id).parent) {
        const Edit& edit = history.row(id).edit;
        if (const auto* lay = edit.as<LaySurface>(); lay && beginsSurface(*lay))
            break;
        const auto* written = edit.as<WriteBack>();
        if (written && agreesAfterwards(*written))
            past.rows.push_back({.what = SurfacePast::What::WrittenBack, .step = nullptr});
        else if (std::shared_ptr<const SurfaceStep> step = surface.step(id))
            past.rows.push_back({.what = edit.is<FollowMask>() ? SurfacePast::What::Followed
                                                               : SurfacePast::What::Deformed,
                .step = std::move(step)});
    }
    return past;
}

Result<EnclosedVoxels> enclosedVoxels(const SimplexMesh& mesh, const SurfacePast& past,
    const VolumeGeometry& geometry, bool sinceLaid)
{
    using What = SurfacePast::What;
    WayBack way(mesh, geometry);
    EnclosedVoxels enclosed;
    Result<VoxelRuns> here = way.voxels();
    if (!here)
        return tl::unexpected(here.error());
    enclosed.now = *here;
    std::vector<Followed> followings; // newest first
    bool isAgreed = false;
    for (const SurfacePast::Row& row : past.rows) {
        if (row.what == What::WrittenBack) {
            if (isAgreed)
                continue;
            if (!(here = way.voxels()))
                return tl::unexpected(here.error());
            enclosed.agreed = afterFollowing(*here, followings);
            isAgreed = true;
            if (!sinceLaid)
                return enclosed;
            continue;
        }
        Result<Followed> followed = way.goBack(row);
        if (!followed)
            return tl::unexpected(followed.error());
        if (!followed->moved.empty())
            followings.push_back(*std::move(followed));
    }
    here = way.voxels();
    if (!here)
        return tl::unexpected(here.error());
    VoxelRuns laid = afterFollowing(*here, followings);
    if (!isAgreed)
        enclosed.agreed = laid;
    if (sinceLaid)
        enclosed.laid = std::move(laid);
    return enclosed;
}

} // namespace core
