// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"

#include <array>

namespace core {

// Changes of structure (seed B §6.4). Each leaves a simplex mesh of the same Euler characteristic,
// or refuses and leaves everything as it is. They refuse where a face that would change has a green
// vertex: the surface that is locked keeps its faces, too.

/// An edge from both ends, and the four faces around it.
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

/// Whether mergeFaces() would not refuse.
[[nodiscard]] bool canMergeFaces(const SimplexMesh& mesh, const EdgeSurroundings& edge);
/// Takes an edge away with both its ends: the faces beside it become one, the left one, and those
/// at its ends lose a vertex each. False: refused.
bool mergeFaces(SimplexMeshEdit& edit, VertexId from, VertexId to);

/// Lays an edge through a face, from the middle of the edge that follows ring[first] to that of the
/// edge that follows ring[second]. The new face lies between the two, with ring[first + 1] …
/// ring[second]; a new vertex is red if either end of its edge is, and else has the mark of the one
/// before. Gives the new vertices; none: refused.
std::optional<std::array<VertexId, 2>> splitFace(
    SimplexMeshEdit& edit, FaceId face, std::size_t first, std::size_t second);

/// Turns an edge by a quarter: the faces beside it part, those at its ends meet. Its ends are
/// laid to either side of its middle, towards their new neighbours. False: refused.
bool swapEdge(SimplexMeshEdit& edit, VertexId from, VertexId to);
[[nodiscard]] bool canSwapEdge(const SimplexMesh& mesh, const EdgeSurroundings& edge);

} // namespace core
