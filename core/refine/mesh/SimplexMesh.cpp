// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SimplexMesh.h"

#include <bit>

namespace core {

namespace {

bool sameBits(const glm::dvec3& one, const glm::dvec3& other)
{
    for (int axis = 0; axis < 3; ++axis) {
        if (std::bit_cast<std::uint64_t>(one[axis]) != std::bit_cast<std::uint64_t>(other[axis]))
            return false;
    }
    return true;
}

/// The least free id below @p slots, else that behind them.
std::uint32_t leastFree(const std::set<std::uint32_t>& free, std::size_t slots)
{
    return free.empty() ? std::uint32_t(slots) : *free.begin();
}

/// A corner of a face: what precedes and follows it there.
struct Corner {
    VertexId before = noId;
    VertexId after = noId;
    FaceId face = noId;
};

} // namespace

bool identical(const SimplexVertex& one, const SimplexVertex& other)
{
    return sameBits(one.positionLps, other.positionLps) && one.neighbours == other.neighbours
        && one.faces == other.faces && one.mark == other.mark;
}

Result<SimplexMesh> SimplexMesh::make(
    std::vector<glm::dvec3> positionsLps, std::vector<FaceRing> rings)
{
    const auto refused = [](const Clause& reason) { return failure(ErrorCode::Internal, reason); };
    std::vector<std::array<Corner, 3>> corners(positionsLps.size());
    std::vector<std::uint8_t> counts(positionsLps.size(), 0);
    for (std::size_t face = 0; face < rings.size(); ++face) {
        const FaceRing& ring = rings[face];
        if (ring.size() < 3)
            return refused(Clause::saying("face %1 has fewer than three vertices", face));
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const VertexId id = ring[i];
            if (id >= positionsLps.size())
                return refused(Clause::saying("face %1 names a vertex that is not there", face));
            if (counts[id] == 3)
                return refused(Clause::saying("more than three faces meet at vertex %1", id));
            corners[id][counts[id]++] = {.before = ring[(i + ring.size() - 1) % ring.size()],
                .after = ring[(i + 1) % ring.size()],
                .face = FaceId(face)};
        }
    }
    SimplexMesh mesh;
    mesh.m_neighbours.resize(positionsLps.size());
    mesh.m_faces.resize(positionsLps.size());
    mesh.m_marks.resize(positionsLps.size(), SurfaceMark::Yellow);
    for (std::size_t id = 0; id < positionsLps.size(); ++id) {
        if (counts[id] != 3)
            return refused(Clause::saying("fewer than three faces meet at vertex %1", id));
        // To the left of the way to the following vertex lies the corner's face; the next face
        // around follows where this one came from.
        std::array<Corner, 3> around = corners[id];
        if (around[1].after != around[0].before)
            std::swap(around[1], around[2]);
        for (std::size_t i = 0; i < 3; ++i) {
            if (around[i].before != around[(i + 1) % 3].after)
                return refused(Clause::saying("the faces at vertex %1 do not close around it", id));
            mesh.m_neighbours[id][i] = around[i].after;
            mesh.m_faces[id][i] = around[i].face;
        }
    }
    mesh.m_positions = std::move(positionsLps);
    mesh.m_rings = std::move(rings);
    if (const auto checked = checkSimplexMesh(mesh); !checked)
        return tl::unexpected(checked.error());
    return mesh;
}

SimplexVertex SimplexMesh::vertex(VertexId id) const
{
    return {.positionLps = m_positions[id],
        .neighbours = m_neighbours[id],
        .faces = m_faces[id],
        .mark = m_marks[id]};
}

int SimplexMesh::slotOf(VertexId id, VertexId neighbour) const
{
    int slot = 0;
    while (slot < 3 && m_neighbours[id][std::size_t(slot)] != neighbour)
        ++slot;
    return slot;
}

FaceId SimplexMesh::faceAcross(const FaceRing& ring, std::size_t i) const
{
    const VertexId next = ring[(i + 1) % ring.size()];
    return m_faces[next][std::size_t(slotOf(next, ring[i]))];
}

std::vector<VertexId> SimplexMesh::vertexIds() const
{
    std::vector<VertexId> ids;
    ids.reserve(vertexCount());
    for (VertexId id = 0; id < vertexSlots(); ++id) {
        if (hasVertex(id))
            ids.push_back(id);
    }
    return ids;
}

std::vector<FaceId> SimplexMesh::faceIds() const
{
    std::vector<FaceId> ids;
    ids.reserve(faceCount());
    for (FaceId id = 0; id < faceSlots(); ++id) {
        if (hasFace(id))
            ids.push_back(id);
    }
    return ids;
}

VertexId SimplexMesh::freeVertex() const
{
    return leastFree(m_freeVertices, m_positions.size());
}

FaceId SimplexMesh::freeFace() const
{
    return leastFree(m_freeFaces, m_rings.size());
}

void SimplexMesh::putVertex(VertexId id, const std::optional<SimplexVertex>& vertex)
{
    const auto resize = [this](std::size_t slots) {
        m_positions.resize(slots, glm::dvec3(0.0));
        m_neighbours.resize(slots, {noId, noId, noId});
        m_faces.resize(slots, {noId, noId, noId});
        m_marks.resize(slots, SurfaceMark::Yellow);
    };
    for (VertexId slot = vertexSlots(); slot <= id; ++slot)
        m_freeVertices.insert(slot);
    if (id >= vertexSlots())
        resize(std::size_t(id) + 1);
    const SimplexVertex written = vertex.value_or(SimplexVertex{});
    m_positions[id] = written.positionLps;
    m_neighbours[id] = written.neighbours;
    m_faces[id] = written.faces;
    m_marks[id] = written.mark;
    if (vertex) {
        m_freeVertices.erase(id);
        return;
    }
    m_freeVertices.insert(id);
    std::size_t slots = m_positions.size();
    while (slots > 0 && !hasVertex(VertexId(slots - 1)))
        m_freeVertices.erase(VertexId(--slots));
    if (slots != m_positions.size())
        resize(slots);
}

void SimplexMesh::putFace(FaceId id, FaceRing ring)
{
    for (FaceId slot = faceSlots(); slot <= id; ++slot)
        m_freeFaces.insert(slot);
    if (id >= faceSlots())
        m_rings.resize(std::size_t(id) + 1);
    if (ring.empty())
        m_freeFaces.insert(id);
    else
        m_freeFaces.erase(id);
    m_rings[id] = std::move(ring);
    while (!m_rings.empty() && m_rings.back().empty()) {
        m_rings.pop_back();
        m_freeFaces.erase(FaceId(m_rings.size()));
    }
}

bool identical(const SimplexMesh& one, const SimplexMesh& other)
{
    if (one.vertexSlots() != other.vertexSlots() || one.faceSlots() != other.faceSlots())
        return false;
    for (VertexId id = 0; id < one.vertexSlots(); ++id) {
        if (!identical(one.vertex(id), other.vertex(id)))
            return false;
    }
    for (FaceId id = 0; id < one.faceSlots(); ++id) {
        if (one.ring(id) != other.ring(id))
            return false;
    }
    return true;
}

} // namespace core
