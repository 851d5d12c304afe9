// SPDX-License-Identifier: Apache-2.0
#include "core/measure/MeasureHandles.h"

namespace core {

std::vector<glm::dvec3> draggedPoints(
    const Measurement& measurement, std::size_t point, const glm::dvec3& placeLps)
{
    using Kind = Measurement::Kind;
    std::vector<glm::dvec3> points = measurement.pointsLps;
    const bool takesAllAlong =
        measurement.kind == Kind::Outline || (measurement.isRegion() && point == 0);
    if (takesAllAlong) {
        const glm::dvec3 way = placeLps - points[point];
        for (glm::dvec3& each : points)
            each += way;
        return points;
    }
    if (measurement.kind != Kind::Ellipse && measurement.kind != Kind::Rectangle) {
        points[point] = placeLps;
        return points;
    }
    const glm::dvec3 side = points[point] - points[0];
    const double length = glm::dot(side, side);
    if (length > 0.0)
        points[point] = points[0] + side * (glm::dot(placeLps - points[0], side) / length);
    return points;
}

} // namespace core
