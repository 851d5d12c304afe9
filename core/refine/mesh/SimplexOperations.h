// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"

#include <array>

namespace core {

// Changes of structure (seed B §6.4). Each one leaves a simplex mesh of the same Euler
// characteristic, or refuses and changes nothing. They refuse if a face that would change has a
// green vertex, since a locked part of the surface keeps its faces too.

/// The ends of an edge, and the four faces around it.
struct EdgeSurroundings {
    VertexId from = noId;
    VertexId to = noId;
    FaceId left = noId;
    FaceId right = noId;
    FaceId behind = noId; ///< touches `from` only
    FaceId ahead = noId; ///< touches `to` only
};
/// @pre the two are neighbours
[[nodiscard]] EdgeSurroundings surroundingsOf(const SimplexMesh& mesh, VertexId from, VertexId to);

/// Whether no vertex of a face is green.
[[nodiscard]] bool isFree(const SimplexMesh& mesh, FaceId id);

/// Whether mergeFaces() would succeed.
[[nodiscard]] bool canMergeFaces(const SimplexMesh& mesh, const EdgeSurroundings& edge);
/// Removes an edge with both its ends: the faces beside it become one (the left one), and the faces
/// at its ends lose one vertex each. False: refused.
bool mergeFaces(SimplexMeshEdit& edit, VertexId from, VertexId to);

/// Adds an edge through a face, from the middle of the edge after ring[first] to the middle of the
/// edge after ring[second]. The new face lies between the two and contains ring[first + 1] …
/// ring[second]. A new vertex is red if either end of its edge is red; otherwise it has the mark of
/// the end before it. Returns the new vertices; none: refused.
std::optional<std::array<VertexId, 2>> splitFace(
    SimplexMeshEdit& edit, FaceId face, std::size_t first, std::size_t second);

/// Rotates an edge by a quarter turn: the faces beside it are separated, and those at its ends
/// become neighbours. Its ends are moved to either side of its middle, towards their new
/// neighbours. False: refused.
bool swapEdge(SimplexMeshEdit& edit, VertexId from, VertexId to);
[[nodiscard]] bool canSwapEdge(const SimplexMesh& mesh, const EdgeSurroundings& edge);

} // namespace core
