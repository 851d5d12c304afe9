// SPDX-License-Identifier: Apache-2.0
#include "core/refine/repair/FaceThinning.h"

#include "core/refine/mesh/SimplexOperations.h"
#include "core/refine/repair/CrossingGuard.h"
#include "core/refine/repair/FaceShape.h"

#include <algorithm>
#include <optional>
#include <queue>

namespace core {

namespace {

/// Of the mean area: many small parts, which keep their faces, do not cost the large ones theirs.
constexpr double greatestShare = 3.0;

class Thinning {
public:
    Thinning(SimplexMesh& mesh, std::size_t vertices, const VolumeGeometry* apartOn,
        const Progress& progress)
        : m_mesh(mesh)
        , m_edit(mesh)
        , m_vertices(vertices)
        , m_areas(mesh.faceSlots())
        , m_versions(mesh.faceSlots(), 0)
    {
        double whole = 0.0;
        for (const FaceId face : mesh.faceIds()) {
            enter(face);
            whole += glm::length(m_areas[face]);
        }
        m_greatest = greatestShare * 2.0 * whole / double(std::max<std::size_t>(vertices, 1));
        if (apartOn)
            m_guard.emplace(mesh, *apartOn, &progress);
    }

    Result<void> run(const Progress& progress)
    {
        for (int step = 0; m_mesh.vertexCount() > m_vertices && !m_queue.empty(); ++step) {
            if (step % 1024 == 0 && progress.cancelled())
                return failure(ErrorCode::Cancelled);
            const Entry entry = m_queue.top();
            m_queue.pop();
            if (m_mesh.hasFace(entry.face) && m_versions[entry.face] == entry.version)
                mergeAway(entry.face);
        }
        m_edit.commit();
        return {};
    }

private:
    struct Entry {
        double areaSquared = 0.0;
        FaceId face = noId;
        std::uint32_t version = 0;
        bool operator<(const Entry& other) const // the least comes first
        {
            return areaSquared != other.areaSquared ? areaSquared > other.areaSquared
                                                    : face > other.face;
        }
    };

    /// An edge over which a face may be merged with a neighbour.
    struct Way {
        double cost = 0.0;
        EdgeSurroundings edge;
    };

    void enter(FaceId face)
    {
        m_areas[face] = areaVectorOf(m_mesh, face);
        m_queue.push({.areaSquared = glm::dot(m_areas[face], m_areas[face]),
            .face = face,
            .version = ++m_versions[face]});
    }

    /// The area of a face without one of its vertices.
    [[nodiscard]] glm::dvec3 areaWithout(FaceId face, VertexId left) const
    {
        const FaceRing& ring = m_mesh.ring(face);
        const std::size_t at =
            std::size_t(std::find(ring.begin(), ring.end(), left) - ring.begin());
        const glm::dvec3 before = m_mesh.position(ring[(at + ring.size() - 1) % ring.size()]);
        const glm::dvec3 after = m_mesh.position(ring[(at + 1) % ring.size()]);
        return m_areas[face] - 0.5 * glm::cross(m_mesh.position(left) - before, after - before);
    }

    /// How little a face gains by losing an edge: a large neighbour, a ring of many vertices, a
    /// short edge.
    [[nodiscard]] double costOf(const EdgeSurroundings& edge) const
    {
        const double ring =
            double(m_mesh.ring(edge.left).size() + m_mesh.ring(edge.right).size()) - 10.0;
        const double length = glm::distance(m_mesh.position(edge.from), m_mesh.position(edge.to));
        const double area = glm::length(m_areas[edge.left]) + glm::length(m_areas[edge.right]);
        return area * (1.0 + 0.25 * std::max(0.0, ring)) / std::max(length, 1e-12);
    }

    [[nodiscard]] bool keepsShape(const EdgeSurroundings& edge) const
    {
        return lookAlike(m_areas[edge.left], m_areas[edge.right])
            && lookAlike(m_areas[edge.behind], areaWithout(edge.behind, edge.from))
            && lookAlike(m_areas[edge.ahead], areaWithout(edge.ahead, edge.to));
    }

    /// The way that costs least of those that cost more than one that was refused, or of all.
    [[nodiscard]] std::optional<Way> bestWay(FaceId face, const std::optional<Way>& refused) const
    {
        const FaceRing& ring = m_mesh.ring(face);
        std::optional<Way> best;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const EdgeSurroundings edge =
                surroundingsOf(m_mesh, ring[i], ring[(i + 1) % ring.size()]);
            const double cost = costOf(edge);
            if ((best && cost >= best->cost) || (refused && cost <= refused->cost)
                || glm::length(m_areas[edge.left] + m_areas[edge.right]) > m_greatest
                || !canMergeFaces(m_mesh, edge) || !keepsShape(edge))
                continue;
            best = Way{.cost = cost, .edge = edge};
        }
        return best;
    }

    bool merges(const EdgeSurroundings& edge)
    {
        const auto merge = [&] { return mergeFaces(m_edit, edge.from, edge.to); };
        return m_guard ? m_guard->attempt(m_edit, merge) : merge();
    }

    void mergeAway(FaceId face)
    {
        for (std::optional<Way> way = bestWay(face, {}); way; way = bestWay(face, way)) {
            if (!merges(way->edge))
                continue;
            for (const FaceId changed : {way->edge.left, way->edge.behind, way->edge.ahead})
                enter(changed);
            return;
        }
    }

    SimplexMesh& m_mesh;
    SimplexMeshEdit m_edit;
    std::size_t m_vertices;
    double m_greatest = 0.0; ///< area of a face
    std::vector<glm::dvec3> m_areas; ///< as vectors, by face
    std::vector<std::uint32_t> m_versions;
    std::priority_queue<Entry> m_queue;
    std::optional<CrossingGuard> m_guard; ///< none: what crosses is not looked at
};

/// The same mesh under ids without gaps.
SimplexMesh closedUp(const SimplexMesh& mesh)
{
    std::vector<VertexId> now(mesh.vertexSlots(), noId);
    std::vector<glm::dvec3> positions;
    for (const VertexId id : mesh.vertexIds()) {
        now[id] = VertexId(positions.size());
        positions.push_back(mesh.position(id));
    }
    std::vector<FaceRing> rings;
    for (const FaceId face : mesh.faceIds()) {
        FaceRing& ring = rings.emplace_back(mesh.ring(face));
        std::transform(
            ring.begin(), ring.end(), ring.begin(), [&](VertexId id) { return now[id]; });
    }
    SimplexMesh made = *SimplexMesh::make(std::move(positions), std::move(rings));
    SimplexMeshEdit edit(made);
    for (const VertexId id : mesh.vertexIds())
        edit.setMark(now[id], mesh.mark(id));
    edit.commit();
    return made;
}

} // namespace

Result<SimplexMesh> thinnedOut(
    SimplexMesh mesh, std::size_t vertices, const Progress& progress, const VolumeGeometry* apartOn)
{
    if (mesh.vertexCount() > vertices) {
        if (const auto done = Thinning(mesh, vertices, apartOn, progress).run(progress); !done)
            return tl::unexpected(done.error());
    }
    return closedUp(mesh);
}

} // namespace core
