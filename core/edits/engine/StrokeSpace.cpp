// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/StrokeSpace.h"

#include "core/edits/engine/SlicePlane.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// Rows are two directions in the plane and the normal.
glm::dmat3 planeAxes(const glm::dvec3& normal)
{
    const glm::dvec3 across = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(across, normal));
    return glm::transpose(glm::dmat3(right, glm::cross(normal, right), normal));
}

/// The same, the first of them along a side of a square or cube.
glm::dmat3 sideAxes(const glm::dvec3& normal, const glm::dvec3& side)
{
    const glm::dvec3 right = glm::normalize(side - normal * glm::dot(normal, side));
    return glm::transpose(glm::dmat3(right, glm::cross(normal, right), normal));
}

} // namespace

StrokeSpace strokeSpace(const BrushPath& path, const VolumeGeometry& geometry)
{
    StrokeSpace space;
    space.middleLps = geometry.toWorld((glm::dvec3(geometry.size) - 1.0) / 2.0);
    for (const glm::dvec3& corner : geometry.cornersLps())
        space.volumeRadiusMm =
            std::max(space.volumeRadiusMm, glm::distance(corner, space.middleLps));
    if (path.shape == BrushPath::Shape::Ball)
        return space;
    const glm::dvec3 normal = glm::normalize(*path.normalLps);
    space.toStroke = isSquare(path.shape) ? sideAxes(normal, *path.sideLps) : planeAxes(normal);
    if (!isFlat(path.shape))
        return space;
    const SlicePlane slice = slicePlane(geometry, normal, path.pointsLps.front());
    space.planeMm = slice.heightMm;
    space.halfThicknessMm = slice.halfThicknessMm;
    // A plane that lies far off meets no voxel, however far.
    const double farMm = 2.0 * space.volumeRadiusMm + 2.0 * space.halfThicknessMm;
    space.planeMm = std::clamp(space.planeMm, -farMm, farMm);
    return space;
}

double finestSpacing(const VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    return std::min({spacing.x, spacing.y, spacing.z});
}

std::array<std::int64_t, 2> piecesNear(
    const glm::dvec3& from, const glm::dvec3& along, std::int64_t pieces, double nearMm)
{
    const double a = glm::dot(along, along);
    const double b = glm::dot(from, along);
    const double c = glm::dot(from, from) - nearMm * nearMm;
    if (a == 0.0)
        return {0, c <= 0.0 ? 1 : 0};
    const double root = b * b - a * c;
    if (root < 0.0)
        return {0, 0};
    const auto at = [&](double t) { return std::clamp(t, 0.0, 1.0) * double(pieces); };
    const double enter = (-b - std::sqrt(root)) / a;
    const double leave = (-b + std::sqrt(root)) / a;
    if (leave < 0.0 || enter > 1.0)
        return {0, 0};
    return {std::max<std::int64_t>(std::int64_t(at(enter)) - 1, 0),
        std::min<std::int64_t>(std::int64_t(at(leave)) + 2, pieces)};
}

} // namespace core
