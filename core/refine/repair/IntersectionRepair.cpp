// SPDX-License-Identifier: Apache-2.0
#include "core/base/SortUnique.h"
#include "core/refine/repair/FaceShape.h"
#include "core/refine/repair/SelfIntersections.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace core {

namespace {

/// Of the way to the middle of the neighbours, at once and so many times a round.
constexpr double share = 0.5;
constexpr int smoothings = 3;
/// The region grows by a ring of neighbours every so many rounds.
constexpr int roundsPerRing = 3;
/// How far sheets that face each other move, in roots of a face's area.
constexpr double retreat = 0.15;
/// They move inwards; where so many rounds gain nothing, outwards, and so on: a thin part may be
/// turned over.
constexpr int roundsPerWay = 8;

std::vector<VertexId> verticesAround(
    const SimplexMesh& mesh, const std::vector<CrossingFaces>& crossings, int rings)
{
    std::vector<VertexId> vertices;
    for (const CrossingFaces& crossing : crossings) {
        for (const FaceId face : {crossing.one, crossing.other})
            vertices.insert(vertices.end(), mesh.ring(face).begin(), mesh.ring(face).end());
    }
    sortUnique(vertices);
    for (int ring = 0; ring < rings; ++ring) {
        const std::size_t count = vertices.size();
        for (std::size_t i = 0; i < count; ++i) {
            for (const VertexId near : mesh.neighbours(vertices[i]))
                vertices.push_back(near);
        }
        sortUnique(vertices);
    }
    return vertices;
}

void smooth(SimplexMeshEdit& edit, const std::vector<VertexId>& vertices)
{
    const SimplexMesh& mesh = edit.mesh();
    std::vector<glm::dvec3> places;
    places.reserve(vertices.size());
    for (const VertexId id : vertices) {
        const auto& near = mesh.neighbours(id);
        const glm::dvec3 middle =
            (mesh.position(near[0]) + mesh.position(near[1]) + mesh.position(near[2])) / 3.0;
        places.push_back(mesh.position(id) + share * (middle - mesh.position(id)));
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
        edit.move(vertices[i], places[i]);
}

/// Moves the faces that face the ones they cross, each once.
void part(SimplexMeshEdit& edit, const std::vector<CrossingFaces>& crossings, double way)
{
    const SimplexMesh& mesh = edit.mesh();
    std::map<VertexId, glm::dvec3> ways;
    for (const CrossingFaces& crossing : crossings) {
        const glm::dvec3 one = areaVectorOf(mesh, crossing.one);
        const glm::dvec3 other = areaVectorOf(mesh, crossing.other);
        if (glm::dot(one, other) >= 0.0)
            continue;
        for (const FaceId face : {crossing.one, crossing.other}) {
            const glm::dvec3 area = face == crossing.one ? one : other;
            const double size = glm::length(area);
            for (const VertexId id : mesh.ring(face))
                ways[id] = way * area / std::sqrt(size);
        }
    }
    for (const auto& [id, aside] : ways)
        edit.move(id, mesh.position(id) + aside);
}

} // namespace

IntersectionRepair repairSelfIntersections(
    SimplexMeshEdit& edit, const VolumeGeometry& geometry, int mostRounds)
{
    IntersectionRepair repair;
    std::vector<CrossingFaces> crossings = selfIntersections(edit.mesh(), geometry);
    repair.before = crossings.size();
    double way = -retreat;
    std::size_t fewest = crossings.size();
    int inVain = 0;
    while (!crossings.empty() && repair.rounds < mostRounds) {
        part(edit, crossings, way);
        const auto vertices = verticesAround(edit.mesh(), crossings, repair.rounds / roundsPerRing);
        for (int i = 0; i < smoothings; ++i)
            smooth(edit, vertices);
        ++repair.rounds;
        crossings = selfIntersections(edit.mesh(), geometry);
        inVain = crossings.size() < fewest ? 0 : inVain + 1;
        fewest = std::min(fewest, crossings.size());
        if (inVain == roundsPerWay) {
            way = -way;
            inVain = 0;
        }
    }
    repair.left = crossings.size();
    return repair;
}

} // namespace core
