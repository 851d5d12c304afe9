// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SurfacePart.h"

#include "core/refine/mesh/SimplexDual.h"

namespace core {

MeshPart partOf(const SimplexMesh& mesh, const glm::dvec3& turn)
{
    const SimplexTriangles triangles = trianglesOf(mesh);
    std::vector<std::uint32_t> places(triangles.pointsLps.size(), noId);
    MeshPart part;
    part.triangles.reserve(triangles.triangles.size());
    for (const glm::uvec3& triangle : triangles.triangles) {
        glm::uvec3 placed(0);
        for (int corner = 0; corner < 3; ++corner) {
            std::uint32_t& place = places[triangle[corner]];
            if (place == noId) {
                place = std::uint32_t(part.vertices.size());
                part.vertices.emplace_back(turn * triangles.pointsLps[triangle[corner]]);
            }
            placed[corner] = place;
        }
        if (turn.x * turn.y * turn.z < 0.0)
            std::swap(placed.y, placed.z);
        part.triangles.push_back(placed);
    }
    return part;
}

} // namespace core
