// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"
#include "core/refine/repair/TriangleCrossing.h"

#include <span>

namespace core {

/// The places of a face on the lattice, from its lowest to its highest.
struct FaceBox {
    glm::ivec3 low{0};
    glm::ivec3 high{-1}; ///< below low: there is no face
    [[nodiscard]] bool empty() const { return high.x < low.x; }
    [[nodiscard]] bool meets(const FaceBox& other) const
    {
        return glm::all(glm::lessThanEqual(low, other.high))
            && glm::all(glm::lessThanEqual(other.low, high));
    }
};

/// A face on the lattice: its corners, and its middle, which is the third corner of each of its
/// triangles (TriangleCrossing.h), one for each edge of the ring.
struct FaceFan {
    FaceBox box;
    LatticeCorner middle;
    std::span<const VertexId> ring;
    const glm::ivec3* points = nullptr; ///< by vertex
    [[nodiscard]] LatticeCorner corner(std::size_t i) const
    {
        const VertexId id = ring[i < ring.size() ? i : 0];
        return {.point = id, .place = points[id]};
    }
    [[nodiscard]] LatticeTriangle triangle(std::size_t i) const
    {
        return {corner(i), corner(i + 1), middle};
    }
};

/// Whether a triangle of the one passes through one of the other. Where a plane divides the two, as
/// it nearly always does, no triangle is looked at.
[[nodiscard]] bool passThroughEachOther(const FaceFan& one, const FaceFan& other);

/// Whether triangles of a face pass through each other. Where it is seen whole from somewhere, no
/// pair is looked at.
[[nodiscard]] bool passesThroughItself(const FaceFan& fan);

} // namespace core
