// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/MarkPaint.h"

#include <algorithm>

namespace core {

std::vector<VertexId> reachedWithin(
    const SimplexMesh& mesh, VertexId from, const glm::dvec3& centreLps, double radiusMm)
{
    std::vector<VertexId> reached{from};
    std::vector<bool> seen(mesh.vertexSlots(), false);
    seen[from] = true;
    for (std::size_t i = 0; i < reached.size(); ++i) {
        for (const VertexId near : mesh.neighbours(reached[i])) {
            const glm::dvec3 way = mesh.position(near) - centreLps;
            if (seen[near] || glm::dot(way, way) > radiusMm * radiusMm)
                continue;
            seen[near] = true;
            reached.push_back(near);
        }
    }
    std::sort(reached.begin(), reached.end());
    return reached;
}

std::vector<VertexId> markedAround(const SimplexMesh& mesh, VertexId first)
{
    std::vector<VertexId> found{first};
    std::vector<bool> seen(mesh.vertexSlots(), false);
    seen[first] = true;
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (const VertexId near : mesh.neighbours(found[i])) {
            if (seen[near] || mesh.mark(near) != mesh.mark(first))
                continue;
            seen[near] = true;
            found.push_back(near);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<VertexId> paintMarks(
    SimplexMeshEdit& edit, const glm::dvec3& placeLps, double radiusMm, SurfaceMark mark)
{
    const SimplexMesh& mesh = edit.mesh();
    const VertexId nearest = nearestVertex(mesh, placeLps, [](VertexId) { return true; });
    if (nearest == noId)
        return {};
    std::vector<VertexId> painted = reachedWithin(mesh, nearest, placeLps, radiusMm);
    std::erase_if(painted, [&](VertexId id) { return mesh.mark(id) == mark; });
    for (const VertexId id : painted)
        edit.setMark(id, mark);
    return painted;
}

void growMarks(SimplexMeshEdit& edit, SurfaceMark mark)
{
    const SimplexMesh& mesh = edit.mesh();
    std::vector<VertexId> grown;
    for (VertexId id = 0; id < mesh.vertexSlots(); ++id) {
        if (!mesh.hasVertex(id) || mesh.mark(id) == mark || mesh.mark(id) == SurfaceMark::Green)
            continue;
        const auto& near = mesh.neighbours(id);
        if (std::any_of(
                near.begin(), near.end(), [&](VertexId other) { return mesh.mark(other) == mark; }))
            grown.push_back(id);
    }
    for (const VertexId id : grown)
        edit.setMark(id, mark);
}

void shrinkMarks(SimplexMeshEdit& edit, SurfaceMark mark)
{
    const SimplexMesh& mesh = edit.mesh();
    std::vector<std::pair<VertexId, SurfaceMark>> left;
    for (VertexId id = 0; id < mesh.vertexSlots(); ++id) {
        if (!mesh.hasVertex(id) || mesh.mark(id) != mark)
            continue;
        const auto& near = mesh.neighbours(id);
        const auto other = std::find_if(
            near.begin(), near.end(), [&](VertexId beside) { return mesh.mark(beside) != mark; });
        if (other != near.end())
            left.emplace_back(
                id, mark == SurfaceMark::Yellow ? mesh.mark(*other) : SurfaceMark::Yellow);
    }
    for (const auto& [id, now] : left)
        edit.setMark(id, now);
}

void exchangeMarks(SimplexMeshEdit& edit, SurfaceMark one, SurfaceMark other)
{
    const SimplexMesh& mesh = edit.mesh();
    for (VertexId id = 0; id < mesh.vertexSlots(); ++id) {
        if (!mesh.hasVertex(id))
            continue;
        if (mesh.mark(id) == one)
            edit.setMark(id, other);
        else if (mesh.mark(id) == other)
            edit.setMark(id, one);
    }
}

} // namespace core
