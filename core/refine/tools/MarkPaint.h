// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"

namespace core {

// Changes of marks (seed B §4.3). They run on the thread that owns the edit; each costs one pass
// over the vertices.

/// Of the vertices for which @p isWanted holds, the one nearest to a place, or the least id of
/// equally near ones; noId if there is none.
template <typename IsWanted>
[[nodiscard]] VertexId nearestVertex(
    const SimplexMesh& mesh, const glm::dvec3& placeLps, const IsWanted& isWanted)
{
    VertexId nearest = noId;
    double least = 0.0;
    for (VertexId id = 0; id < mesh.vertexSlots(); ++id) {
        if (!mesh.hasVertex(id) || !isWanted(id))
            continue;
        const glm::dvec3 way = mesh.position(id) - placeLps;
        const double squared = glm::dot(way, way);
        if (nearest != noId && squared >= least)
            continue;
        nearest = id;
        least = squared;
    }
    return nearest;
}

/// The vertices within the ball that are connected with @p from within the ball, including @p from
/// in any case; ascending.
[[nodiscard]] std::vector<VertexId> reachedWithin(
    const SimplexMesh& mesh, VertexId from, const glm::dvec3& centreLps, double radiusMm);

/// The vertices connected with a vertex that have its mark, including itself; ascending.
[[nodiscard]] std::vector<VertexId> markedAround(const SimplexMesh& mesh, VertexId first);

/// Paints a dab of MarkBrush; the nearest vertex is painted however small the ball. Returns the
/// painted vertices, ascending.
std::vector<VertexId> paintMarks(
    SimplexMeshEdit& edit, const glm::dvec3& placeLps, double radiusMm, SurfaceMark mark);
/// Gives the mark to all neighbours of marked vertices that are not green.
void growMarks(SimplexMeshEdit& edit, SurfaceMark mark);
/// Turns marked vertices yellow that are next to others. If the mark is yellow, they take the mark
/// of their first neighbour that is not yellow.
void shrinkMarks(SimplexMeshEdit& edit, SurfaceMark mark);
/// Replaces each of two marks by the other.
void exchangeMarks(SimplexMeshEdit& edit, SurfaceMark one, SurfaceMark other);

} // namespace core
