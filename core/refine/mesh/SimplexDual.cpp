// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SimplexDual.h"

#include <algorithm>

namespace core {

namespace {

/// A triangle at one of its corners: the triangle that follows around the corner to the left has
/// `second` for its `first`.
struct Spoke {
    std::uint32_t triangle = 0;
    std::uint32_t first = 0;
    std::uint32_t second = 0;
};

/// Those of all points, one after the other.
struct Spokes {
    std::vector<std::size_t> begins; ///< by point, and one behind
    std::vector<Spoke> spokes;
};

Spokes spokesOf(std::size_t points, std::span<const glm::uvec3> triangles)
{
    Spokes made;
    made.begins.resize(points + 1, 0);
    for (const glm::uvec3& triangle : triangles) {
        for (int i = 0; i < 3; ++i)
            ++made.begins[std::size_t(triangle[i]) + 1];
    }
    for (std::size_t i = 1; i <= points; ++i)
        made.begins[i] += made.begins[i - 1];
    made.spokes.resize(made.begins.back());
    std::vector<std::size_t> next(made.begins.begin(), made.begins.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (int i = 0; i < 3; ++i)
            made.spokes[next[triangles[t][i]]++] = {.triangle = std::uint32_t(t),
                .first = triangles[t][(i + 1) % 3],
                .second = triangles[t][(i + 2) % 3]};
    }
    return made;
}

/// The triangles around a point, to the left; empty if they do not form one closed fan.
FaceRing fanOf(std::span<const Spoke> spokes)
{
    FaceRing ring;
    std::uint32_t at = spokes.front().first;
    do {
        const auto next = std::find_if(
            spokes.begin(), spokes.end(), [&](const Spoke& spoke) { return spoke.first == at; });
        if (next == spokes.end() || ring.size() == spokes.size())
            return {};
        ring.push_back(next->triangle);
        at = next->second;
    } while (at != spokes.front().first);
    return ring.size() == spokes.size() ? ring : FaceRing{};
}

} // namespace

Result<SimplexMesh> dualOf(
    std::span<const glm::dvec3> pointsLps, std::span<const glm::uvec3> triangles)
{
    for (const glm::uvec3& triangle : triangles) {
        if (glm::any(glm::greaterThanEqual(triangle, glm::uvec3(std::uint32_t(pointsLps.size())))))
            return failure(
                ErrorCode::Internal, Clause::saying("a triangle names a point that is not there"));
    }
    std::vector<glm::dvec3> middles;
    middles.reserve(triangles.size());
    for (const glm::uvec3& triangle : triangles)
        middles.push_back(
            (pointsLps[triangle.x] + pointsLps[triangle.y] + pointsLps[triangle.z]) / 3.0);
    const Spokes spokes = spokesOf(pointsLps.size(), triangles);
    std::vector<FaceRing> rings;
    for (std::size_t point = 0; point < pointsLps.size(); ++point) {
        const std::size_t begin = spokes.begins[point];
        const std::size_t count = spokes.begins[point + 1] - begin;
        if (count == 0)
            continue;
        rings.push_back(fanOf(std::span(spokes.spokes).subspan(begin, count)));
        if (rings.back().empty())
            return failure(ErrorCode::Internal,
                Clause::saying("the triangles at point %1 do not close around it", point));
    }
    return SimplexMesh::make(std::move(middles), std::move(rings));
}

glm::dvec3 middleOf(const SimplexMesh& mesh, FaceId face)
{
    glm::dvec3 sum(0.0);
    for (const VertexId id : mesh.ring(face))
        sum += mesh.position(id);
    return sum / double(mesh.ring(face).size());
}

SimplexTriangles trianglesOf(const SimplexMesh& mesh)
{
    SimplexTriangles made;
    const auto positions = mesh.positions();
    made.pointsLps.reserve(positions.size() + mesh.faceSlots());
    made.pointsLps.assign(positions.begin(), positions.end());
    made.triangles.reserve(3 * mesh.vertexCount());
    made.faces.reserve(3 * mesh.vertexCount());
    for (FaceId face = 0; face < mesh.faceSlots(); ++face) {
        const FaceRing& ring = mesh.ring(face);
        made.pointsLps.push_back(ring.empty() ? glm::dvec3(0.0) : middleOf(mesh, face));
        for (std::size_t i = 0; i < ring.size(); ++i) {
            made.triangles.emplace_back(
                ring[i], ring[(i + 1) % ring.size()], mesh.vertexSlots() + face);
            made.faces.push_back(face);
        }
    }
    return made;
}

double enclosedMm3(const SimplexMesh& mesh)
{
    const SimplexTriangles surface = trianglesOf(mesh);
    if (surface.triangles.empty())
        return 0.0;
    // From a point nearby, or what cancels would cost digits.
    const glm::dvec3 from = surface.pointsLps[surface.triangles.front().x];
    double sixfold = 0.0;
    for (const glm::uvec3& triangle : surface.triangles)
        sixfold += glm::dot(surface.pointsLps[triangle.x] - from,
            glm::cross(surface.pointsLps[triangle.y] - from, surface.pointsLps[triangle.z] - from));
    return sixfold / 6.0;
}

} // namespace core
