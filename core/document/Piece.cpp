// SPDX-License-Identifier: Apache-2.0
#include "core/document/Piece.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

constexpr double degreesPerRadian = 57.29577951308232;

} // namespace

glm::dmat3 rotationMatrix(const glm::dvec3& rotationDegrees)
{
    const double degrees = glm::length(rotationDegrees);
    if (degrees < 1e-12)
        return glm::dmat3(1.0);
    const glm::dvec3 a = rotationDegrees / degrees;
    const double c = std::cos(degrees / degreesPerRadian);
    const double s = std::sin(degrees / degreesPerRadian);
    const glm::dmat3 cross(
        glm::dvec3(0, a.z, -a.y), glm::dvec3(-a.z, 0, a.x), glm::dvec3(a.y, -a.x, 0));
    return glm::dmat3(c) + s * cross + (1.0 - c) * glm::outerProduct(a, a);
}

glm::dvec3 rotationDegrees(const glm::dmat3& m)
{
    // As a quaternion, by its greatest component: exact near 0° and near 180° alike.
    const glm::dvec4 squares(1 + m[0].x + m[1].y + m[2].z, 1 + m[0].x - m[1].y - m[2].z,
        1 - m[0].x + m[1].y - m[2].z, 1 - m[0].x - m[1].y + m[2].z);
    int greatest = 0;
    for (int i = 1; i < 4; ++i) {
        if (squares[i] > squares[greatest])
            greatest = i;
    }
    const double w = m[1].z - m[2].y;
    const double v = m[2].x - m[0].z;
    const double u = m[0].y - m[1].x;
    glm::dvec4 q(squares.x, w, v, u); // w, x, y, z; times four of the greatest
    if (greatest == 1)
        q = {w, squares.y, m[0].y + m[1].x, m[2].x + m[0].z};
    else if (greatest == 2)
        q = {v, m[0].y + m[1].x, squares.z, m[1].z + m[2].y};
    else if (greatest == 3)
        q = {u, m[2].x + m[0].z, m[1].z + m[2].y, squares.w};
    q = glm::normalize(q);
    if (q.x < 0.0)
        q = -q;
    const glm::dvec3 axis(q.y, q.z, q.w);
    const double sine = glm::length(axis);
    if (sine < 1e-15)
        return glm::dvec3(0.0);
    return axis / sine * (2.0 * std::atan2(sine, q.x) * degreesPerRadian);
}

glm::dvec3 pivotOf(const Piece& piece, const VolumeGeometry& geometry)
{
    return piece.pivotLps.value_or(geometry.toWorld((glm::dvec3(geometry.size) - 1.0) / 2.0));
}

glm::dmat4 shownFromTrue(const Piece& piece, const VolumeGeometry& geometry)
{
    if (piece.pose.isHome())
        return glm::dmat4(1.0);
    const glm::dvec3 pivot = pivotOf(piece, geometry);
    const glm::dmat3 turned = rotationMatrix(piece.pose.rotationDegrees) * piece.pose.zoom;
    glm::dmat4 shown(turned);
    shown[3] = glm::dvec4(pivot - turned * pivot + piece.pose.offsetMm, 1.0);
    return shown;
}

} // namespace core
