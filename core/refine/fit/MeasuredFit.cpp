// SPDX-License-Identifier: Apache-2.0
#include "core/refine/fit/MeasuredFit.h"

#include "core/brick/VoxelRunSets.h"
#include "core/refine/fit/InitialFit.h"
#include "core/refine/repair/CrossingGuard.h"
#include "core/refine/repair/SelfIntersections.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "core/volume/WorldToIndex.h"

#include <algorithm>
#include <array>
#include <utility>

namespace core {

namespace {

/// Another try is worth its time only with so many times the vertices of the first.
constexpr double leastGain = 1.25;
/// In voxels.
constexpr int farthestLaying = 4;
constexpr int mostRepairRounds = 20;
/// Of the faces between mask and background: as many vertices are tried first, where that is less
/// than what follows, which the tools can still do with.
constexpr std::array<double, 2> firstShares{0.25, 0.5};
constexpr double fewestVertices = 2000.0;
/// Twice as many vertices enclose no more than so many times better: a rugged mask is not tried.
constexpr double mostGain = 4.0;

class Fitting {
public:
    Fitting(const VoxelRuns& voxels, const VolumeGeometry& geometry, const MeasuredFitRules& rules,
        const Progress& progress)
        : m_voxels(voxels)
        , m_mask(BoxMask::of(voxels, geometry.size))
        , m_geometry(geometry)
        , m_keepsApart(rules.keepsApart)
        , m_mostVertices(rules.mostVertices)
        , m_progress(progress)
    {
    }

    [[nodiscard]] Result<MeasuredFit> ofAbout(int vertices, bool mendsCrossings = true) const
    {
        Result<SimplexMesh> mesh = initialFit(m_mask, m_geometry,
            {.vertices = vertices, .mendsCrossings = mendsCrossings, .keepsApart = m_keepsApart},
            m_progress);
        if (!mesh)
            return tl::unexpected(mesh.error());
        return measured(*std::move(mesh));
    }

    /// Where few vertices do, many would only be slow.
    [[nodiscard]] Result<MeasuredFit> asFewAsItTakes() const
    {
        const glm::u64vec3 faces = m_mask.borderFaces();
        const double all = double(faces.x + faces.y + faces.z);
        for (const double share : firstShares) {
            const double vertices = std::max(fewestVertices, share * all);
            if (leastGain * vertices > std::max(double(leastVertices), all))
                break;
            Result<MeasuredFit> fit = ofAbout(int(std::min(vertices, double(m_mostVertices))));
            if (!fit || isGood(*fit))
                return fit;
            if (double(fit->voxelsOff) > mostGain * mostOffShare * double(fit->voxels))
                break;
        }
        return asTheMaskTakes();
    }

    [[nodiscard]] Result<MeasuredFit> asTheMaskTakes() const
    {
        const glm::u64vec3 faces = m_mask.borderFaces();
        const double all = double(faces.x + faces.y + faces.z);
        const auto bounded = [this](double vertices) {
            return int(std::clamp(vertices, double(leastVertices), double(m_mostVertices)));
        };
        if (leastGain * all > double(m_mostVertices))
            return ofAbout(bounded(all));
        // Mending takes long where it is of no use: in surfaces too coarse for their mask.
        Result<MeasuredFit> fit = ofAbout(bounded(all), false);
        if (fit && isGood(*fit))
            fit = mended(std::move(fit->mesh));
        if (!fit || isGood(*fit))
            return fit;
        Result<MeasuredFit> finer =
            voxelByVoxel(refineSurfaceOf(m_mask, m_geometry, bounded(2.0 * all), m_progress));
        if (!finer || finer->voxelsOff < fit->voxelsOff)
            return finer;
        return mended(std::move(fit->mesh));
    }

    /// The last resort: from where nothing crosses, and no step lets it.
    [[nodiscard]] Result<MeasuredFit> withoutCrossings(MeasuredFit fit) const
    {
        const auto count = [this](MeasuredFit& counted) {
            counted.crossings = selfIntersections(counted.mesh, m_geometry).size();
        };
        count(fit);
        if (fit.crossings == 0)
            return fit;
        Result<MeasuredFit> anew = voxelByVoxel(
            borderSurfaceOf(m_mask, m_geometry, int(fit.mesh.vertexCount()), m_progress));
        if (anew)
            count(*anew);
        return anew;
    }

private:
    [[nodiscard]] static bool isGood(const MeasuredFit& fit)
    {
        return double(fit.voxelsOff) <= mostOffShare * double(fit.voxels);
    }

    /// The voxels in which what it encloses is not the mask.
    [[nodiscard]] Result<VoxelRuns> offIn(const SimplexMesh& mesh) const
    {
        const Result<VoxelRuns> inside = voxelsOf(mesh, m_geometry, m_progress);
        if (!inside)
            return inside;
        return differing(*inside, m_voxels);
    }

    [[nodiscard]] Result<MeasuredFit> measured(SimplexMesh&& mesh) const
    {
        const Result<VoxelRuns> off = offIn(mesh);
        if (!off)
            return tl::unexpected(off.error());
        return MeasuredFit{.mesh = std::move(mesh),
            .voxels = m_voxels.voxelCount(),
            .voxelsOff = off->voxelCount()};
    }

    [[nodiscard]] Result<MeasuredFit> mended(SimplexMesh&& mesh) const
    {
        SimplexMeshEdit edit(mesh);
        repairSelfIntersections(edit, m_geometry, mostRepairRounds);
        edit.commit();
        return measured(std::move(mesh));
    }

    /// As it is laid, such a surface encloses every voxel; forces even it out.
    [[nodiscard]] Result<MeasuredFit> voxelByVoxel(const Result<SimplexMesh>& laid) const
    {
        if (!laid)
            return tl::unexpected(laid.error());
        SimplexMesh mesh = *laid;
        if (const Result<void> done = fitToMask(mesh, m_mask, m_geometry,
                {.restructureEvery = 0, .keepsApart = m_keepsApart}, m_progress);
            !done)
            return tl::unexpected(done.error());
        Result<MeasuredFit> best = measured(std::move(mesh));
        for (int reach = 1; best && !isGood(*best) && reach <= farthestLaying; ++reach) {
            const Result<VoxelRuns> off = offIn(best->mesh);
            if (!off)
                return tl::unexpected(off.error());
            mesh = best->mesh;
            layAgain(mesh, *laid, BoxMask::of(*off, m_geometry.size), reach);
            if (m_keepsApart) {
                Result<MeasuredFit> next = measured(std::move(mesh));
                if (!next || next->voxelsOff < best->voxelsOff)
                    best = std::move(next);
                continue;
            }
            SimplexMesh crossed = mesh;
            Result<MeasuredFit> next = mended(std::move(mesh));
            // Where the two are at odds the voxels count for more.
            if (next && !isGood(*next)) {
                Result<MeasuredFit> unmended = measured(std::move(crossed));
                if (!unmended || isGood(*unmended))
                    next = std::move(unmended);
            }
            if (!next || next->voxelsOff < best->voxelsOff)
                best = std::move(next);
        }
        return best;
    }

    /// Brings the vertices within so many voxels of one that is off back to where they were laid.
    void layAgain(SimplexMesh& mesh, const SimplexMesh& laid, const BoxMask& off, int reach) const
    {
        const WorldToIndex toIndex(m_geometry);
        const auto isNear = [&](const glm::dvec3& placeLps) {
            const glm::ivec3 middle(glm::round(toIndex(placeLps)));
            for (int z = -reach; z <= reach; ++z)
                for (int y = -reach; y <= reach; ++y)
                    for (int x = -reach; x <= reach; ++x)
                        if (off.contains(middle + glm::ivec3(x, y, z)))
                            return true;
            return false;
        };
        std::optional<CrossingGuard> guard;
        if (m_keepsApart)
            guard.emplace(mesh, m_geometry);
        SimplexMeshEdit edit(mesh);
        std::vector<VertexId> moved;
        for (const VertexId id : laid.vertexIds()) {
            if (!isNear(mesh.position(id)) && !isNear(laid.position(id)))
                continue;
            edit.move(id, laid.position(id));
            moved.push_back(id);
        }
        if (guard) {
            guard->moved(moved);
            static_cast<void>(guard->keepApart(edit));
        }
        edit.commit();
    }

    const VoxelRuns& m_voxels;
    BoxMask m_mask;
    const VolumeGeometry& m_geometry;
    bool m_keepsApart;
    int m_mostVertices;
    const Progress& m_progress;
};

} // namespace

Result<MeasuredFit> measuredFit(const VoxelRuns& mask, const VolumeGeometry& geometry,
    std::optional<int> vertices, const Progress& progress, const MeasuredFitRules& rules)
{
    const Fitting fitting(mask, geometry, rules, progress);
    Result<MeasuredFit> fit = vertices ? fitting.ofAbout(*vertices)
        : rules.keepsApart             ? fitting.asFewAsItTakes()
                                       : fitting.asTheMaskTakes();
    return fit && rules.keepsApart ? fitting.withoutCrossings(*std::move(fit)) : fit;
}

} // namespace core
