// SPDX-License-Identifier: Apache-2.0
#include "core/refine/fit/CrossingParts.h"

#include "core/refine/fit/MeasuredFit.h"
#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/repair/SelfIntersections.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "core/volume/WorldToIndex.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace core {

namespace {

/// The connected parts of a mesh, and which of them are chosen.
class ChosenParts {
public:
    explicit ChosenParts(const SimplexMesh& mesh)
        : m_partOf(mesh.vertexSlots(), noId)
    {
        std::uint32_t parts = 0;
        std::vector<VertexId> stack;
        for (const VertexId first : mesh.vertexIds()) {
            if (m_partOf[first] != noId)
                continue;
            m_partOf[first] = parts;
            stack.push_back(first);
            while (!stack.empty()) {
                const VertexId id = stack.back();
                stack.pop_back();
                for (const VertexId near : mesh.neighbours(id)) {
                    if (m_partOf[near] != noId)
                        continue;
                    m_partOf[near] = parts;
                    stack.push_back(near);
                }
            }
            ++parts;
        }
        m_isChosen.resize(parts, false);
        m_isHollow = hollowsOf(mesh);
    }

    /// Chooses the part of a vertex. False: it was chosen already, or was no vertex.
    bool choose(VertexId id)
    {
        if (id >= m_partOf.size() || m_partOf[id] == noId || m_isChosen[m_partOf[id]])
            return false;
        m_isChosen[m_partOf[id]] = true;
        if (m_isHollow[m_partOf[id]])
            m_isChosen.assign(m_isChosen.size(), true);
        return true;
    }
    [[nodiscard]] bool has(VertexId id) const
    {
        return id < m_partOf.size() && m_partOf[id] != noId && m_isChosen[m_partOf[id]];
    }
    [[nodiscard]] std::size_t count() const
    {
        return std::size_t(std::count(m_isChosen.begin(), m_isChosen.end(), true));
    }
    [[nodiscard]] int vertices() const
    {
        return int(std::count_if(m_partOf.begin(), m_partOf.end(),
            [this](std::uint32_t part) { return part != noId && m_isChosen[part]; }));
    }

private:
    /// By part: it is oriented inwards, as that around a hollow is.
    [[nodiscard]] std::vector<bool> hollowsOf(const SimplexMesh& mesh) const
    {
        const SimplexTriangles surface = trianglesOf(mesh);
        std::vector<double> sixfold(m_isChosen.size(), 0.0);
        // From a point nearby, or what cancels would cost digits.
        std::vector<std::uint32_t> from(m_isChosen.size(), noId);
        for (const glm::uvec3& triangle : surface.triangles) {
            const std::uint32_t part = m_partOf[triangle.x];
            if (from[part] == noId)
                from[part] = triangle.x;
            const glm::dvec3& origin = surface.pointsLps[from[part]];
            sixfold[part] += glm::dot(surface.pointsLps[triangle.x] - origin,
                glm::cross(surface.pointsLps[triangle.y] - origin,
                    surface.pointsLps[triangle.z] - origin));
        }
        std::vector<bool> isHollow;
        isHollow.reserve(sixfold.size());
        for (const double volume : sixfold)
            isHollow.push_back(volume <= 0.0);
        return isHollow;
    }

    std::vector<std::uint32_t> m_partOf; ///< by vertex
    std::vector<bool> m_isChosen; ///< by part
    std::vector<bool> m_isHollow; ///< by part
};

/// The marks of chosen vertices, by the voxel in which they lie.
class MarksAround {
public:
    MarksAround(const SimplexMesh& mesh, const ChosenParts& chosen, const VolumeGeometry& geometry)
        : m_mesh(mesh)
        , m_toIndex(geometry)
    {
        for (const VertexId id : mesh.vertexIds()) {
            if (chosen.has(id))
                m_cells[cellOf(mesh.position(id))].push_back(id);
        }
    }

    /// That of the nearest vertex in the smallest cube of voxels that has any; red, which stays
    /// where it is, if there is none nearby.
    [[nodiscard]] SurfaceMark at(const glm::dvec3& placeLps) const
    {
        const Cell middle = cellOf(placeLps);
        for (int reach = 0; reach <= farthestVoxels; ++reach) {
            const VertexId nearest = nearestWithin(middle, reach, placeLps);
            if (nearest != noId)
                return m_mesh.mark(nearest);
        }
        return SurfaceMark::Red;
    }

private:
    using Cell = std::array<int, 3>;
    static constexpr int farthestVoxels = 6;

    [[nodiscard]] Cell cellOf(const glm::dvec3& placeLps) const
    {
        const glm::ivec3 voxel = latticePoint(m_toIndex(placeLps)) >> LatticeSurface::bits;
        return {voxel.x, voxel.y, voxel.z};
    }
    [[nodiscard]] VertexId nearestWithin(
        const Cell& middle, int reach, const glm::dvec3& placeLps) const
    {
        VertexId nearest = noId;
        double least = 0.0;
        for (int z = middle[2] - reach; z <= middle[2] + reach; ++z) {
            for (int y = middle[1] - reach; y <= middle[1] + reach; ++y) {
                for (int x = middle[0] - reach; x <= middle[0] + reach; ++x) {
                    const auto cell = m_cells.find({x, y, z});
                    if (cell == m_cells.end())
                        continue;
                    for (const VertexId id : cell->second) {
                        const glm::dvec3 way = m_mesh.position(id) - placeLps;
                        const double squared = glm::dot(way, way);
                        if (nearest != noId && squared >= least)
                            continue;
                        nearest = id;
                        least = squared;
                    }
                }
            }
        }
        return nearest;
    }

    const SimplexMesh& m_mesh;
    WorldToIndex m_toIndex;
    std::map<Cell, std::vector<VertexId>> m_cells;
};

/// The voxels that the chosen parts enclose together.
Result<VoxelRuns> voxelsWithin(const SimplexMesh& mesh, const ChosenParts& chosen,
    const VolumeGeometry& geometry, const Progress& progress)
{
    LatticeSurface surface = onLattice(mesh, geometry);
    std::erase_if(surface.triangles,
        [&chosen](const glm::uvec3& triangle) { return !chosen.has(triangle.x); });
    return fillSurface(surface, SurfaceKind::Closed, geometry.size, progress);
}

/// Puts another mesh in the place of the chosen parts.
void replaceBy(const SimplexMesh& laid, SimplexMeshEdit& edit, const ChosenParts& chosen,
    const std::vector<SurfaceMark>& marks)
{
    const SimplexMesh& mesh = edit.mesh();
    for (const FaceId face : mesh.faceIds()) {
        if (chosen.has(mesh.ring(face).front()))
            edit.removeFace(face);
    }
    for (const VertexId id : mesh.vertexIds()) {
        if (!chosen.has(id))
            continue;
        edit.setMark(id, SurfaceMark::Yellow); // green ones are not to be removed
        edit.removeVertex(id);
    }
    std::vector<VertexId> now(laid.vertexSlots(), noId);
    for (const VertexId id : laid.vertexIds())
        now[id] = edit.addVertex(
            {.positionLps = laid.position(id), .neighbours = {0, 0, 0}, .faces = {0, 0, 0}});
    std::vector<FaceId> nowFace(laid.faceSlots(), noId);
    for (const FaceId face : laid.faceIds()) {
        FaceRing ring = laid.ring(face);
        std::transform(
            ring.begin(), ring.end(), ring.begin(), [&now](VertexId id) { return now[id]; });
        nowFace[face] = edit.addFace(std::move(ring));
    }
    for (const VertexId id : laid.vertexIds()) {
        std::array<VertexId, 3> neighbours{};
        std::array<FaceId, 3> faces{};
        for (std::size_t i = 0; i < 3; ++i) {
            neighbours[i] = now[laid.neighbours(id)[i]];
            faces[i] = nowFace[laid.facesAt(id)[i]];
        }
        edit.link(now[id], neighbours, faces);
        edit.setMark(now[id], marks[id]);
    }
}

std::vector<SurfaceMark> marksFor(
    const SimplexMesh& laid, const MarksAround& around, const Progress& progress)
{
    std::vector<SurfaceMark> marks(laid.vertexSlots(), SurfaceMark::Yellow);
    for (const VertexId id : laid.vertexIds()) {
        if (progress.cancelled())
            break;
        marks[id] = around.at(laid.position(id));
    }
    return marks;
}

} // namespace

Result<LaidAnew> layCrossingsAnew(
    SimplexMeshEdit& edit, const VolumeGeometry& geometry, const Progress& progress)
{
    const SimplexMesh& mesh = edit.mesh();
    std::vector<CrossingFaces> crossings = selfIntersections(mesh, geometry);
    LaidAnew done{.before = crossings.size()};
    if (crossings.empty())
        return done;
    ChosenParts chosen(mesh);
    for (const CrossingFaces& pair : crossings) {
        chosen.choose(mesh.ring(pair.one).front());
        chosen.choose(mesh.ring(pair.other).front());
    }
    for (;;) {
        const Result<VoxelRuns> voxels = voxelsWithin(mesh, chosen, geometry, progress);
        if (!voxels)
            return tl::unexpected(voxels.error());
        const Result<MeasuredFit> fit =
            measuredFit(*voxels, geometry, chosen.vertices(), progress, {.keepsApart = true});
        if (!fit)
            return tl::unexpected(fit.error());
        const std::vector<SurfaceMark> marks =
            marksFor(fit->mesh, MarksAround(mesh, chosen, geometry), progress);
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        SimplexMesh whole = mesh;
        SimplexMeshEdit trial(whole);
        replaceBy(fit->mesh, trial, chosen, marks);
        trial.commit();
        if (whole.vertexCount() == 0)
            return failure(ErrorCode::InvalidField, QStringLiteral("surface"),
                Clause::saying("what passes through itself encloses no voxel"));
        crossings = selfIntersections(whole, geometry);
        if (crossings.empty()) {
            replaceBy(fit->mesh, edit, chosen, marks);
            done.parts = chosen.count();
            return done;
        }
        // What stays has its ids; the others are of what was laid in the place of chosen ones.
        bool isMore = false;
        for (const CrossingFaces& pair : crossings) {
            for (const FaceId face : {pair.one, pair.other})
                isMore |= chosen.choose(whole.ring(face).front());
        }
        if (!isMore) {
            done.left = crossings.size();
            return done;
        }
    }
}

} // namespace core
