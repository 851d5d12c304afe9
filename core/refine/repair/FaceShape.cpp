// SPDX-License-Identifier: Apache-2.0
#include "core/refine/repair/FaceShape.h"

#include "core/refine/mesh/SimplexDual.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

constexpr int sweeps = 8;
/// An element off the diagonal, squared, against those on it.
constexpr double nothing = 1e-26;

/// The eigenvectors of a symmetric matrix as columns, and its eigenvalues in the diagonal, by
/// Jacobi's rotations: they need no more than a square root.
void diagonalise(glm::dmat3& matrix, glm::dmat3& vectors)
{
    vectors = glm::dmat3(1.0);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (int p = 0; p < 2; ++p) {
            for (int q = p + 1; q < 3; ++q) {
                const double off = matrix[p][q];
                if (off * off <= nothing * std::abs(matrix[p][p] * matrix[q][q]))
                    continue;
                const double theta = (matrix[q][q] - matrix[p][p]) / (2.0 * off);
                const double root = std::sqrt(theta * theta + 1.0);
                const double t = theta >= 0.0 ? 1.0 / (theta + root) : 1.0 / (theta - root);
                const double c = 1.0 / std::sqrt(t * t + 1.0);
                const double s = t * c;
                glm::dmat3 turn(1.0);
                turn[p][p] = c;
                turn[q][q] = c;
                turn[p][q] = -s;
                turn[q][p] = s;
                matrix = glm::transpose(turn) * matrix * turn;
                vectors = vectors * turn;
            }
        }
    }
}

} // namespace

glm::dvec3 areaVectorOf(const SimplexMesh& mesh, FaceId face)
{
    const FaceRing& ring = mesh.ring(face);
    const glm::dvec3 from = mesh.position(ring[0]);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        sum += glm::cross(mesh.position(ring[i]) - from, mesh.position(ring[i + 1]) - from);
    return 0.5 * sum;
}

bool lookAlike(const glm::dvec3& one, const glm::dvec3& other)
{
    const double product = glm::dot(one, other);
    return product > 0.0 && product * product >= 0.5 * glm::dot(one, one) * glm::dot(other, other);
}

double areaOf(const SimplexMesh& mesh, FaceId face)
{
    const FaceRing& ring = mesh.ring(face);
    const glm::dvec3 middle = middleOf(mesh, face);
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        twice += glm::length(glm::cross(
            mesh.position(ring[i]) - middle, mesh.position(ring[(i + 1) % ring.size()]) - middle));
    return 0.5 * twice;
}

FaceShape shapeOf(const SimplexMesh& mesh, FaceId face)
{
    const FaceRing& ring = mesh.ring(face);
    FaceShape shape;
    shape.middleLps = middleOf(mesh, face);
    shape.areaMm2 = areaOf(mesh, face);
    glm::dmat3 spread(0.0);
    for (const VertexId id : ring) {
        const glm::dvec3 way = mesh.position(id) - shape.middleLps;
        spread += glm::outerProduct(way, way);
    }
    glm::dmat3 axes;
    diagonalise(spread, axes);
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(
        order.begin(), order.end(), [&](int a, int b) { return spread[a][a] > spread[b][b]; });
    const double share = 1.0 / double(ring.size());
    shape.longWay = axes[order[0]];
    shape.lengthMm = 2.0 * std::sqrt(std::max(0.0, spread[order[0]][order[0]] * share));
    shape.widthMm = 2.0 * std::sqrt(std::max(0.0, spread[order[1]][order[1]] * share));
    const glm::dvec3 outwards = areaVectorOf(mesh, face);
    shape.normalLps = axes[order[2]];
    const double side = glm::dot(shape.normalLps, outwards);
    if (side < 0.0)
        shape.normalLps = -shape.normalLps;
    else if (!(side > 0.0))
        shape.normalLps = glm::dvec3(0.0);
    return shape;
}

} // namespace core
