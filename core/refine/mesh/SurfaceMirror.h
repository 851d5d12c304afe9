// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SurfaceUpdate.h"

#include <array>
#include <optional>
#include <vector>

namespace core {

/// Where a ray meets a surface.
struct MeshHit {
    glm::dvec3 placeLps{0.0};
    glm::dvec3 normalLps{0.0}; ///< outwards, of length 1
    double distanceMm = 0.0; ///< along the ray
    VertexId vertex = noId; ///< the nearest of the face that was hit
};

/// Which side of its faces a ray may meet.
enum class FaceSides {
    Outer, ///< the outside alone, as of a closed surface that is seen from outside
    Both, ///< the inside as well, which is seen where a part of the surface is hidden
};

/// A connected part of the surface with one mark; a red one is an error.
struct MarkedRegion {
    glm::dvec3 middleLps{0.0}; ///< the mean of its vertices
    glm::dvec3 normalLps{0.0}; ///< the mean of their normals, of length 1; 0 if that is undefined
    double areaMm2 = 0.0;
    std::size_t vertices = 0;
    VertexId first = noId; ///< its least vertex
};

/// A copy of a surface for another thread, kept up to date by SurfaceUpdate: for picking, and for
/// lists of marked regions. Belongs to one thread.
class SurfaceMirror {
public:
    void take(const SurfaceUpdate& update);

    [[nodiscard]] bool empty() const { return m_faceCount == 0; }
    [[nodiscard]] std::size_t vertexCount() const { return m_vertexCount; }
    [[nodiscard]] std::size_t faceCount() const { return m_faceCount; }
    [[nodiscard]] const SurfaceUpdate::Vertex& vertex(VertexId id) const { return m_vertices[id]; }

    /// The first point of the surface that the ray meets; none: it misses. Every face is tested:
    /// 72 000 triangles take about a millisecond.
    /// @param directionLps of length 1
    [[nodiscard]] std::optional<MeshHit> hit(const glm::dvec3& fromLps,
        const glm::dvec3& directionLps, FaceSides sides = FaceSides::Outer) const;
    /// The nearest vertex; noId if there is none.
    [[nodiscard]] VertexId nearestVertex(const glm::dvec3& placeLps) const;
    /// Largest area first, then by their least vertex.
    [[nodiscard]] std::vector<MarkedRegion> regions(SurfaceMark mark) const;
    /// The same for the vertices selected by @p isWanted, by id.
    [[nodiscard]] std::vector<MarkedRegion> regions(const std::vector<bool>& isWanted) const;
    /// Calls @p visit(id, vertex) for every vertex, ascending.
    template <class Visit> void forEachVertex(const Visit& visit) const
    {
        for (VertexId id = 0; id < m_vertices.size(); ++id) {
            if (m_uses[id] > 0)
                visit(id, m_vertices[id]);
        }
    }
    /// Calls @p visit(one, other) for pairs of neighbours, twice for each pair.
    template <class Visit> void forEachEdge(const Visit& visit) const
    {
        for (const FaceRing& ring : m_rings) {
            for (std::size_t i = 0; i < ring.size(); ++i)
                visit(ring[i], ring[(i + 1) % ring.size()]);
        }
    }
    /// One past the greatest id.
    [[nodiscard]] std::size_t vertexSlots() const { return m_vertices.size(); }
    /// How many vertices have each mark, by its number.
    [[nodiscard]] std::array<std::size_t, 3> markCounts() const;

private:
    void putRing(FaceId face, const FaceRing& ring);
    [[nodiscard]] glm::dvec3 middleOf(const FaceRing& ring) const;

    std::vector<SurfaceUpdate::Vertex> m_vertices; ///< by id
    std::vector<int> m_uses; ///< by vertex: number of faces that contain it
    std::vector<FaceRing> m_rings; ///< by id; empty: there is no such face
    std::size_t m_vertexCount = 0;
    std::size_t m_faceCount = 0;
};

} // namespace core
