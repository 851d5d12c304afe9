// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/refine/mesh/SurfaceMark.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace core {

using VertexId = std::uint32_t;
using FaceId = std::uint32_t;
/// Stands for no vertex and no face.
constexpr std::uint32_t noId = std::numeric_limits<std::uint32_t>::max();

/// Everything about a vertex.
///
/// Seen from outside, the neighbours are in counter-clockwise order. faces[i] is to the left of the
/// edge to neighbours[i], so its ring contains neighbours[i + 1], the vertex, neighbours[i] in this
/// order.
struct SimplexVertex {
    glm::dvec3 positionLps{0.0}; ///< world, mm
    std::array<VertexId, 3> neighbours{noId, noId, noId};
    std::array<FaceId, 3> faces{noId, noId, noId};
    SurfaceMark mark = SurfaceMark::Yellow;
};
/// Compares bit by bit, so that 0 and −0 differ.
[[nodiscard]] bool identical(const SimplexVertex& one, const SimplexVertex& other);

/// The vertices around a face, counter-clockwise seen from outside.
using FaceRing = std::vector<VertexId>;

/// A 2-simplex mesh (Delingette 1999): a closed surface of polygons, three of which meet at each
/// vertex. It may have any number of components, each of any genus.
///
/// A value. Positions are world LPS mm, in double. Ids do not change while the structure changes
/// around them; a new vertex or face gets the least free id, so the mesh is completely described by
/// its vertices and faces. It is written only through SimplexMeshEdit, which records the previous
/// state.
class SimplexMesh {
public:
    SimplexMesh() = default;
    /// Makes a mesh; the ids are the indices of the lists, and all vertices are yellow. Errors:
    /// Internal (the rings do not form a simplex mesh; argument 0 says why).
    [[nodiscard]] static Result<SimplexMesh> make(
        std::vector<glm::dvec3> positionsLps, std::vector<FaceRing> rings);

    [[nodiscard]] std::size_t vertexCount() const { return vertexSlots() - m_freeVertices.size(); }
    [[nodiscard]] std::size_t faceCount() const { return faceSlots() - m_freeFaces.size(); }
    /// One past the greatest id; not every id below it is in use.
    [[nodiscard]] VertexId vertexSlots() const { return VertexId(m_positions.size()); }
    [[nodiscard]] FaceId faceSlots() const { return FaceId(m_rings.size()); }
    [[nodiscard]] bool hasVertex(VertexId id) const
    {
        return id < vertexSlots() && m_neighbours[id][0] != noId;
    }
    [[nodiscard]] bool hasFace(FaceId id) const { return id < faceSlots() && !m_rings[id].empty(); }

    [[nodiscard]] SimplexVertex vertex(VertexId id) const;
    [[nodiscard]] const glm::dvec3& position(VertexId id) const { return m_positions[id]; }
    [[nodiscard]] const std::array<VertexId, 3>& neighbours(VertexId id) const
    {
        return m_neighbours[id];
    }
    [[nodiscard]] const std::array<FaceId, 3>& facesAt(VertexId id) const { return m_faces[id]; }
    [[nodiscard]] SurfaceMark mark(VertexId id) const { return m_marks[id]; }
    /// Empty if there is no such face.
    [[nodiscard]] const FaceRing& ring(FaceId id) const { return m_rings[id]; }

    /// By vertex id, for drawing; entries of vertices that do not exist are at the origin.
    [[nodiscard]] std::span<const glm::dvec3> positions() const { return m_positions; }
    [[nodiscard]] std::span<const SurfaceMark> marks() const { return m_marks; }

    /// The index of @p neighbour among the neighbours of @p id; 3: it is none.
    [[nodiscard]] int slotOf(VertexId id, VertexId neighbour) const;
    /// The face on the other side of the edge from ring[i] to the vertex that follows it.
    [[nodiscard]] FaceId faceAcross(const FaceRing& ring, std::size_t i) const;
    [[nodiscard]] std::vector<VertexId> vertexIds() const; ///< ascending
    [[nodiscard]] std::vector<FaceId> faceIds() const; ///< ascending

private:
    friend class SimplexMeshEdit;
    friend struct SimplexMeshDelta;

    [[nodiscard]] VertexId freeVertex() const;
    [[nodiscard]] FaceId freeFace() const;
    void putVertex(VertexId id, const std::optional<SimplexVertex>& vertex);
    void putFace(FaceId id, FaceRing ring);

    std::vector<glm::dvec3> m_positions;
    std::vector<std::array<VertexId, 3>> m_neighbours; ///< noId: the vertex does not exist
    std::vector<std::array<FaceId, 3>> m_faces;
    std::vector<SurfaceMark> m_marks;
    std::vector<FaceRing> m_rings;
    std::set<VertexId> m_freeVertices; ///< unused ids below vertexSlots()
    std::set<FaceId> m_freeFaces;
};

/// Compares vertices, faces and their ids bit by bit.
[[nodiscard]] bool identical(const SimplexMesh& one, const SimplexMesh& other);

/// A connected part of a mesh.
struct SimplexComponent {
    VertexId first = noId; ///< its least vertex
    std::size_t vertices = 0;
    std::size_t faces = 0;
    /// V − E + F: 2 for a ball, 0 with one handle.
    [[nodiscard]] int eulerCharacteristic() const { return int(faces) - int(vertices / 2); }
};

/// Checks the structure of a mesh: each vertex has three neighbours, which have it as a neighbour,
/// and three faces; each ring has three vertices or more, none twice, and agrees with the vertices;
/// two faces share at most one edge. So the mesh is closed, manifold and oriented, every face is a
/// disc, and its dual is a simplicial surface, on which the operations rely. Returns its
/// components. Errors: Internal, argument 0 says what is wrong and where.
[[nodiscard]] Result<std::vector<SimplexComponent>> checkSimplexMesh(const SimplexMesh& mesh);

} // namespace core
