// SPDX-License-Identifier: Apache-2.0
#include "core/measure/PlaneShape.h"

#include "core/measure/WoundArea.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core {

namespace {

double crossOf(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

} // namespace

glm::dvec2 PlaneShape::inPlane(const glm::dvec3& placeLps) const
{
    const glm::dvec3 way = placeLps - originLps;
    return {glm::dot(way, rightLps), glm::dot(way, upLps)};
}

glm::dvec3 PlaneShape::toLps(const glm::dvec2& place) const
{
    return originLps + place.x * rightLps + place.y * upLps;
}

double PlaneShape::offPlaneMm(const Measurement& measurement) const
{
    double most = 0.0;
    for (const glm::dvec3& point : measurement.pointsLps)
        most = std::max(most, std::abs(glm::dot(point - originLps, normalLps())));
    return most;
}

bool PlaneShape::contains(const glm::dvec2& place) const
{
    if (kind == Measurement::Kind::Outline)
        return isWound(points, place);
    // The place as s·a + t·b from the first point; a little more than the border for rounding.
    const glm::dvec2 a = points[1] - points[0];
    const glm::dvec2 b = points[2] - points[0];
    const glm::dvec2 way = place - points[0];
    const double s = crossOf(way, b) / crossOf(a, b);
    const double t = crossOf(a, way) / crossOf(a, b);
    constexpr double little = 1e-9;
    if (kind == Measurement::Kind::Ellipse)
        return s * s + t * t <= 1.0 + little;
    return s >= -little && t >= -little && s <= 1.0 + little && t <= 1.0 + little;
}

double PlaneShape::areaMm2() const
{
    if (kind == Measurement::Kind::Outline)
        return woundArea(points);
    const double both = std::abs(crossOf(points[1] - points[0], points[2] - points[0]));
    return kind == Measurement::Kind::Ellipse ? std::numbers::pi * both : both;
}

std::vector<glm::dvec2> PlaneShape::border(int ellipseCorners) const
{
    if (kind == Measurement::Kind::Outline)
        return points;
    const glm::dvec2 a = points[1] - points[0];
    const glm::dvec2 b = points[2] - points[0];
    if (kind == Measurement::Kind::Rectangle)
        return {points[0], points[1], points[1] + b, points[2]};
    std::vector<glm::dvec2> corners;
    for (int i = 0; i < ellipseCorners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / ellipseCorners;
        corners.push_back(points[0] + std::cos(angle) * a + std::sin(angle) * b);
    }
    return corners;
}

std::optional<PlaneShape> planeShape(const Measurement& measurement)
{
    const std::vector<glm::dvec3>& points = measurement.pointsLps;
    if (points.size() < 3)
        return std::nullopt;
    // The plane of the points that lie farthest apart suffers least from their rounding.
    PlaneShape shape;
    shape.originLps = points.front();
    glm::dvec3 along(0.0);
    for (const glm::dvec3& point : points) {
        if (glm::distance(point, points.front()) > glm::length(along))
            along = point - points.front();
    }
    if (glm::length(along) < PlaneShape::leastHeightMm)
        return std::nullopt;
    shape.rightLps = glm::normalize(along);
    glm::dvec3 across(0.0);
    for (const glm::dvec3& point : points) {
        const glm::dvec3 way = point - points.front();
        const glm::dvec3 side = way - glm::dot(way, shape.rightLps) * shape.rightLps;
        if (glm::length(side) > glm::length(across))
            across = side;
    }
    if (glm::length(across) < PlaneShape::leastHeightMm)
        return std::nullopt;
    shape.upLps = glm::normalize(across);
    shape.kind = measurement.kind;
    for (const glm::dvec3& point : points)
        shape.points.push_back(shape.inPlane(point));
    return shape;
}

glm::dvec2 halfAxes(const glm::dvec3& a, const glm::dvec3& b)
{
    const double middle = (glm::dot(a, a) + glm::dot(b, b)) / 2.0;
    const double half = (glm::dot(a, a) - glm::dot(b, b)) / 2.0;
    const double apart = std::hypot(half, glm::dot(a, b));
    return {std::sqrt(middle + apart), std::sqrt(std::max(0.0, middle - apart))};
}

} // namespace core
