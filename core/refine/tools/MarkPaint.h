// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"

namespace core {

// Marks of vertices (seed B §4.3). Any thread that owns the edit; cost: once over the vertices.

/// The vertex nearest to a place, the least of those equally near, of those for which @p isWanted;
/// noId: there is none.
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

/// Those within the ball that are reached along the surface, within the ball, from @p from, which
/// is one of them in any case; ascending.
[[nodiscard]] std::vector<VertexId> reachedWithin(
    const SimplexMesh& mesh, VertexId from, const glm::dvec3& centreLps, double radiusMm);

/// Those that hang together with a vertex and bear its mark, itself included; ascending.
[[nodiscard]] std::vector<VertexId> markedAround(const SimplexMesh& mesh, VertexId first);

/// What a dab of MarkBrush does; the nearest vertex is painted however small the ball. Gives those
/// that got the mark, ascending.
std::vector<VertexId> paintMarks(
    SimplexMeshEdit& edit, const glm::dvec3& placeLps, double radiusMm, SurfaceMark mark);
/// Neighbours of what has the mark get it, but for green ones.
void growMarks(SimplexMeshEdit& edit, SurfaceMark mark);
/// What has the mark beside others is yellow then; yellow takes the mark of its first neighbour
/// that is not.
void shrinkMarks(SimplexMeshEdit& edit, SurfaceMark mark);
/// Those that have the one mark get the other.
void exchangeMarks(SimplexMeshEdit& edit, SurfaceMark one, SurfaceMark other);

} // namespace core
