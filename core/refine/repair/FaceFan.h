// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"
#include "core/refine/repair/TriangleCrossing.h"

#include <span>

namespace core {

/// The box around a face on the lattice, both corners included.
struct FaceBox {
    glm::ivec3 low{0};
    glm::ivec3 high{-1}; ///< less than low: there is no face
    [[nodiscard]] bool empty() const { return high.x < low.x; }
    [[nodiscard]] bool meets(const FaceBox& other) const
    {
        return glm::all(glm::lessThanEqual(low, other.high))
            && glm::all(glm::lessThanEqual(other.low, high));
    }
};

/// A face on the lattice: its corners and its middle. It consists of one triangle for each edge of
/// the ring, with the middle as third corner (TriangleCrossing.h).
struct FaceFan {
    FaceBox box;
    LatticeCorner middle;
    std::span<const VertexId> ring;
    const glm::ivec3* points = nullptr; ///< positions, by vertex id
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

/// Whether a triangle of one face passes through a triangle of the other. If a plane separates the
/// faces, as is nearly always the case, no triangles are compared.
[[nodiscard]] bool passThroughEachOther(const FaceFan& one, const FaceFan& other);

/// Whether triangles of a face pass through each other. If the whole face is visible from some
/// direction, no triangles are compared.
[[nodiscard]] bool passesThroughItself(const FaceFan& fan);

} // namespace core
