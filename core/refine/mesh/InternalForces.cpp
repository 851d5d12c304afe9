// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/InternalForces.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// The three neighbours: their plane and the circle through them.
struct NeighbourCircle {
    bool exists = false; ///< false: they lie in a line
    glm::dvec3 normal{0.0};
    glm::dvec3 centre{0.0};
    double radiusSquared = 0.0;
};

NeighbourCircle circleOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 u = b - a;
    const glm::dvec3 v = c - a;
    const glm::dvec3 across = glm::cross(u, v);
    const double uu = glm::dot(u, u);
    const double vv = glm::dot(v, v);
    const double area = glm::dot(across, across);
    constexpr double least = 1e-10;
    if (!(area > least * (uu + vv) * (uu + vv)))
        return {};
    const glm::dvec3 way = glm::cross(uu * v - vv * u, across) / (2.0 * area);
    return {.exists = true,
        .normal = across / std::sqrt(area),
        .centre = a + way,
        .radiusSquared = glm::dot(way, way)};
}

NeighbourCircle circleAt(const SimplexMesh& mesh, VertexId id)
{
    const auto& near = mesh.neighbours(id);
    return circleOf(mesh.position(near[0]), mesh.position(near[1]), mesh.position(near[2]));
}

} // namespace

SimplexFrame frameAt(const SimplexMesh& mesh, VertexId id)
{
    const NeighbourCircle circle = circleAt(mesh, id);
    if (!circle.exists)
        return {};
    const glm::dvec3 way = mesh.position(id) - circle.centre;
    const double height = glm::dot(way, circle.normal);
    // Of the sphere's centre: (way² − radius²) / (2 height); its radius follows.
    const double off = glm::dot(way, way) - circle.radiusSquared;
    const double twice = std::sqrt(off * off + 4.0 * height * height * circle.radiusSquared);
    return {.normalLps = circle.normal, .curvaturePerMm = twice > 0.0 ? 2.0 * height / twice : 0.0};
}

glm::dvec3 internalForceMm(const SimplexMesh& mesh, VertexId id, double curvaturePerMm)
{
    const auto& near = mesh.neighbours(id);
    const glm::dvec3 middle =
        (mesh.position(near[0]) + mesh.position(near[1]) + mesh.position(near[2])) / 3.0;
    const NeighbourCircle circle = circleAt(mesh, id);
    if (!circle.exists)
        return middle - mesh.position(id);
    const glm::dvec3 aside = middle - circle.centre;
    const double asideSquared = glm::dot(aside, aside);
    const double widest = std::max(circle.radiusSquared, asideSquared);
    const double bent = std::min(curvaturePerMm * curvaturePerMm, 1.0 / widest);
    const double curvature = curvaturePerMm < 0.0 ? -std::sqrt(bent) : std::sqrt(bent);
    // The sphere of that curvature through the circle, on the side where it is the lesser part.
    const double roots = std::sqrt(std::max(0.0, 1.0 - bent * asideSquared))
        + std::sqrt(std::max(0.0, 1.0 - bent * circle.radiusSquared));
    const double height =
        roots > 0.0 ? curvature * (circle.radiusSquared - asideSquared) / roots : 0.0;
    return middle + height * circle.normal - mesh.position(id);
}

} // namespace core
