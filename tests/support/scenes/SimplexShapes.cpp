// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/SimplexShapes.h"

#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/mesh/SimplexOperations.h"

#include <QtGlobal>

#include <algorithm>
#include <cmath>
#include <map>

namespace test {

namespace {

TriangleSurface icosahedron()
{
    const double t = (1.0 + std::sqrt(5.0)) / 2.0;
    return {.points = {{-1, t, 0}, {1, t, 0}, {-1, -t, 0}, {1, -t, 0}, {0, -1, t}, {0, 1, t},
                {0, -1, -t}, {0, 1, -t}, {t, 0, -1}, {t, 0, 1}, {-t, 0, -1}, {-t, 0, 1}},
        .triangles = {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9},
            {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8}, {3, 9, 4}, {3, 4, 2}, {3, 2, 6},
            {3, 6, 8}, {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}}};
}

} // namespace

TriangleSurface icosphere(double radius, int cuts)
{
    TriangleSurface surface = icosahedron();
    for (int cut = 0; cut < cuts; ++cut) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, isNew] = middles.try_emplace(
                {std::min(a, b), std::max(a, b)}, std::uint32_t(surface.points.size()));
            if (isNew)
                surface.points.push_back(
                    glm::normalize(surface.points[a]) + glm::normalize(surface.points[b]));
            return found->second;
        };
        std::vector<glm::uvec3> finer;
        for (const glm::uvec3& t : surface.triangles) {
            const glm::uvec3 m(middle(t.x, t.y), middle(t.y, t.z), middle(t.z, t.x));
            for (const glm::uvec3& part : {glm::uvec3(t.x, m.x, m.z), glm::uvec3(t.y, m.y, m.x),
                     glm::uvec3(t.z, m.z, m.y), m})
                finer.push_back(part);
        }
        surface.triangles = std::move(finer);
    }
    for (glm::dvec3& point : surface.points)
        point = radius * glm::normalize(point);
    return surface;
}

TriangleSurface torus(double radius, double thickness, int around, int across)
{
    TriangleSurface surface;
    const auto at = [&](int i, int j) { return std::uint32_t((i % around) * across + j % across); };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double u = 2.0 * M_PI * i / around;
            const double v = 2.0 * M_PI * j / across;
            const double out = radius + thickness * std::cos(v);
            surface.points.emplace_back(
                out * std::cos(u), out * std::sin(u), thickness * std::sin(v));
            surface.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            surface.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }
    return surface;
}

TriangleSurface moved(TriangleSurface surface, const glm::dvec3& by)
{
    for (glm::dvec3& point : surface.points)
        point += by;
    return surface;
}

TriangleSurface together(TriangleSurface one, const TriangleSurface& other)
{
    const auto first = std::uint32_t(one.points.size());
    one.points.insert(one.points.end(), other.points.begin(), other.points.end());
    for (const glm::uvec3& triangle : other.triangles)
        one.triangles.push_back(triangle + first);
    return one;
}

core::SimplexMesh simplexMesh(const TriangleSurface& surface)
{
    auto mesh = core::dualOf(surface.points, surface.triangles);
    if (!mesh)
        qFatal("%s", qPrintable(mesh.error().arguments.value(0)));
    return *std::move(mesh);
}

core::SimplexMesh simplexSphere(double radius, int cuts)
{
    core::SimplexMesh mesh = simplexMesh(icosphere(radius, cuts));
    core::SimplexMeshEdit edit(mesh);
    for (const core::VertexId id : mesh.vertexIds())
        edit.move(id, radius * glm::normalize(mesh.position(id)));
    edit.commit();
    return mesh;
}

std::vector<int> eulerCharacteristics(const core::SimplexMesh& mesh)
{
    std::vector<int> characteristics;
    const auto components = core::checkSimplexMesh(mesh);
    if (!components) {
        qWarning("%s", qPrintable(components.error().arguments.value(0)));
        return characteristics;
    }
    for (const core::SimplexComponent& component : *components)
        characteristics.push_back(component.eulerCharacteristic());
    std::sort(characteristics.begin(), characteristics.end());
    return characteristics;
}

bool randomOperation(core::SimplexMeshEdit& edit, Random& random)
{
    const core::SimplexMesh& mesh = edit.mesh();
    core::VertexId id = 0;
    do
        id = core::VertexId(randomInt(random, 0, int(mesh.vertexSlots()) - 1));
    while (!mesh.hasVertex(id));
    const auto slot = std::size_t(randomInt(random, 0, 2));
    switch (randomInt(random, 0, 2)) {
    case 0:
        return core::mergeFaces(edit, id, mesh.neighbours(id)[slot]);
    case 1:
        return core::swapEdge(edit, id, mesh.neighbours(id)[slot]);
    default:
        const core::FaceId face = mesh.facesAt(id)[slot];
        const int last = int(mesh.ring(face).size()) - 1;
        const auto first = std::size_t(randomInt(random, 0, last));
        return core::splitFace(edit, face, first, std::size_t(randomInt(random, 0, last)))
            .has_value();
    }
}

} // namespace test
