// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SimplexMesh.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// What is wrong with a vertex; empty: nothing.
Clause faultOf(const SimplexMesh& mesh, VertexId id)
{
    const auto& neighbours = mesh.neighbours(id);
    const auto& faces = mesh.facesAt(id);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!std::isfinite(mesh.position(id)[int(i)]))
            return Clause::saying("vertex %1 lies nowhere", id);
        if (!mesh.hasVertex(neighbours[i]) || neighbours[i] == id
            || neighbours[i] == neighbours[(i + 1) % 3])
            return Clause::saying("vertex %1 has no three neighbours", id);
        if (mesh.slotOf(neighbours[i], id) == 3)
            return Clause::saying("vertex %1 is no neighbour of its neighbours", id);
        if (!mesh.hasFace(faces[i]) || faces[i] == faces[(i + 1) % 3])
            return Clause::saying("vertex %1 has no three faces", id);
        const FaceRing& ring = mesh.ring(faces[i]);
        const auto here = std::find(ring.begin(), ring.end(), id);
        if (here == ring.end())
            return Clause::saying("vertex %1 is not in the ring of its face", id);
        const std::size_t at = std::size_t(here - ring.begin());
        if (ring[(at + 1) % ring.size()] != neighbours[i]
            || ring[(at + ring.size() - 1) % ring.size()] != neighbours[(i + 1) % 3])
            return Clause::saying("the faces of vertex %1 do not turn around it to the left", id);
    }
    return {};
}

Clause faultOfFace(const SimplexMesh& mesh, FaceId id)
{
    const FaceRing& ring = mesh.ring(id);
    if (ring.size() < 3)
        return Clause::saying("face %1 has fewer than three vertices", id);
    FaceRing sorted = ring;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
        return Clause::saying("face %1 passes a vertex twice", id);
    std::vector<FaceId> beside;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (!mesh.hasVertex(ring[i]))
            return Clause::saying("face %1 names a vertex that is not there", id);
        const auto& faces = mesh.facesAt(ring[i]);
        if (std::find(faces.begin(), faces.end(), id) == faces.end())
            return Clause::saying("a vertex does not know face %1", id);
    }
    for (std::size_t i = 0; i < ring.size(); ++i)
        beside.push_back(mesh.faceAcross(ring, i));
    std::sort(beside.begin(), beside.end());
    if (std::adjacent_find(beside.begin(), beside.end()) != beside.end())
        return Clause::saying("face %1 shares two edges with another", id);
    return {};
}

std::vector<SimplexComponent> componentsOf(const SimplexMesh& mesh)
{
    std::vector<SimplexComponent> components;
    std::vector<bool> seen(mesh.vertexSlots(), false);
    std::vector<bool> seenFaces(mesh.faceSlots(), false);
    std::vector<VertexId> stack;
    for (VertexId first = 0; first < mesh.vertexSlots(); ++first) {
        if (seen[first] || !mesh.hasVertex(first))
            continue;
        SimplexComponent component{.first = first};
        seen[first] = true;
        stack.push_back(first);
        while (!stack.empty()) {
            const VertexId id = stack.back();
            stack.pop_back();
            ++component.vertices;
            for (std::size_t i = 0; i < 3; ++i) {
                const FaceId face = mesh.facesAt(id)[i];
                if (!seenFaces[face])
                    ++component.faces;
                seenFaces[face] = true;
                const VertexId next = mesh.neighbours(id)[i];
                if (seen[next])
                    continue;
                seen[next] = true;
                stack.push_back(next);
            }
        }
        components.push_back(component);
    }
    return components;
}

} // namespace

Result<std::vector<SimplexComponent>> checkSimplexMesh(const SimplexMesh& mesh)
{
    for (VertexId id = 0; id < mesh.vertexSlots(); ++id) {
        if (!mesh.hasVertex(id))
            continue;
        if (const Clause fault = faultOf(mesh, id); !fault.isEmpty())
            return failure(ErrorCode::Internal, fault);
    }
    for (FaceId id = 0; id < mesh.faceSlots(); ++id) {
        if (!mesh.hasFace(id))
            continue;
        if (const Clause fault = faultOfFace(mesh, id); !fault.isEmpty())
            return failure(ErrorCode::Internal, fault);
    }
    return componentsOf(mesh);
}

} // namespace core
