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
/// No vertex, no face.
constexpr std::uint32_t noId = std::numeric_limits<std::uint32_t>::max();

/// All that there is about a vertex.
///
/// Seen from outside, the neighbours stand around it to the left; faces[i] lies to the left on the
/// way to neighbours[i], so its ring passes neighbours[i + 1], the vertex, neighbours[i].
struct SimplexVertex {
    glm::dvec3 positionLps{0.0}; ///< world, mm
    std::array<VertexId, 3> neighbours{noId, noId, noId};
    std::array<FaceId, 3> faces{noId, noId, noId};
    SurfaceMark mark = SurfaceMark::Yellow;
};
/// To the bit, so that 0 and −0 differ.
[[nodiscard]] bool identical(const SimplexVertex& one, const SimplexVertex& other);

/// The vertices around a face, to the left seen from outside.
using FaceRing = std::vector<VertexId>;

/// A 2-simplex mesh (Delingette 1999): a closed surface of polygons, three of which meet at each
/// vertex. Any number of components, each of any genus.
///
/// A value. Positions are world LPS mm, in double. Ids stay while the structure changes around
/// them; a new vertex or face gets the least id that is free, so the mesh is its vertices and its
/// faces and nothing besides. It is written through SimplexMeshEdit alone, which knows what was
/// there before.
class SimplexMesh {
public:
    SimplexMesh() = default;
    /// Vertices and faces get their places in the lists as ids; all are yellow. Errors: Internal
    /// (the rings do not make a simplex mesh; argument 0 says why).
    [[nodiscard]] static Result<SimplexMesh> make(
        std::vector<glm::dvec3> positionsLps, std::vector<FaceRing> rings);

    [[nodiscard]] std::size_t vertexCount() const { return vertexSlots() - m_freeVertices.size(); }
    [[nodiscard]] std::size_t faceCount() const { return faceSlots() - m_freeFaces.size(); }
    /// One past the greatest id; what lies below need not exist.
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
    /// Empty: there is no such face.
    [[nodiscard]] const FaceRing& ring(FaceId id) const { return m_rings[id]; }

    /// By vertex id, for whoever draws them; what does not exist lies at the origin.
    [[nodiscard]] std::span<const glm::dvec3> positions() const { return m_positions; }
    [[nodiscard]] std::span<const SurfaceMark> marks() const { return m_marks; }

    /// The place of @p neighbour among those of @p id; 3: it is none.
    [[nodiscard]] int slotOf(VertexId id, VertexId neighbour) const;
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
    std::set<VertexId> m_freeVertices; ///< below the slots
    std::set<FaceId> m_freeFaces;
};

/// Vertices, faces and their ids, to the bit.
[[nodiscard]] bool identical(const SimplexMesh& one, const SimplexMesh& other);

/// A part of a mesh that hangs together.
struct SimplexComponent {
    VertexId first = noId; ///< its least vertex
    std::size_t vertices = 0;
    std::size_t faces = 0;
    /// V − E + F: 2 for a ball, 0 with one handle.
    [[nodiscard]] int eulerCharacteristic() const { return int(faces) - int(vertices / 2); }
};

/// Whether a mesh is what it has to be: each vertex has three neighbours, which have it, and three
/// faces; rings have three vertices or more, none twice, and say the same as the vertices; two
/// faces share one edge at most. So it is closed, manifold and oriented, every face is a disc, and
/// taking the faces' triangles for vertices' gives a simplicial surface, on which the operations
/// rely. Errors: Internal, argument 0 says what is wrong where.
[[nodiscard]] Result<std::vector<SimplexComponent>> checkSimplexMesh(const SimplexMesh& mesh);

} // namespace core
