// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SurfaceUpdate.h"

#include "core/refine/mesh/InternalForces.h"

#include <algorithm>

namespace core {

namespace {

SurfaceUpdate::Vertex drawnVertex(const SimplexMesh& mesh, VertexId id)
{
    return {.id = id,
        .positionLps = mesh.position(id),
        .normalLps = frameAt(mesh, id).normalLps,
        .mark = mesh.mark(id)};
}

} // namespace

SurfaceUpdate wholeUpdate(const SimplexMesh& mesh)
{
    SurfaceUpdate update{.isWhole = true};
    update.vertices.reserve(mesh.vertexCount());
    for (const VertexId id : mesh.vertexIds())
        update.vertices.push_back(drawnVertex(mesh, id));
    update.faces.reserve(mesh.faceCount());
    for (const FaceId id : mesh.faceIds())
        update.faces.push_back({.id = id, .ring = mesh.ring(id)});
    return update;
}

SurfaceUpdate updateOf(const SimplexMesh& mesh, const WrittenParts& written)
{
    std::vector<VertexId> ids;
    ids.reserve(4 * written.vertices.size());
    for (const VertexId id : written.vertices) {
        if (!mesh.hasVertex(id))
            continue;
        ids.push_back(id);
        for (const VertexId neighbour : mesh.neighbours(id))
            ids.push_back(neighbour);
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());

    SurfaceUpdate update;
    update.vertices.reserve(ids.size());
    for (const VertexId id : ids)
        update.vertices.push_back(drawnVertex(mesh, id));
    update.faces.reserve(written.faces.size());
    for (const FaceId id : written.faces)
        update.faces.push_back({.id = id, .ring = mesh.hasFace(id) ? mesh.ring(id) : FaceRing{}});
    return update;
}

} // namespace core
