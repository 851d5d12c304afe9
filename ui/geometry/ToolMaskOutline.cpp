// SPDX-License-Identifier: Apache-2.0
#include "ui/geometry/ToolMaskOutline.h"

#include "core/sculpt/OutlineRaster.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace ui {

namespace {

constexpr int acrossElements = 256; ///< for measuring what is covered
/// Of the square around it: a slit of a hundredth of its length covers that much.
constexpr double leastShare = 0.002;
constexpr double leastSideMm = 1e-3;
constexpr std::size_t mostPoints = 20000;
constexpr double roundingSlack = 1e-9;

double distanceToSegment(const glm::dvec2& point, const glm::dvec2& from, const glm::dvec2& to)
{
    const glm::dvec2 way = to - from;
    const double length2 = glm::dot(way, way);
    const double along =
        length2 > 0.0 ? std::clamp(glm::dot(point - from, way) / length2, 0.0, 1.0) : 0.0;
    return glm::length(point - from - along * way);
}

/// The points that matter, after Douglas and Peucker; the ends stay.
std::vector<glm::dvec2> simplified(const std::vector<glm::dvec2>& curve, double tolerance)
{
    std::vector<bool> kept(curve.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> stretches{{0, curve.size() - 1}};
    while (!stretches.empty()) {
        const auto [from, to] = stretches.back();
        stretches.pop_back();
        std::size_t farthest = from;
        double distance = tolerance;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double here = distanceToSegment(curve[i], curve[from], curve[to]);
            if (here > distance) {
                distance = here;
                farthest = i;
            }
        }
        if (farthest == from)
            continue;
        kept[farthest] = true;
        stretches.emplace_back(from, farthest);
        stretches.emplace_back(farthest, to);
    }
    std::vector<glm::dvec2> result;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        if (kept[i])
            result.push_back(curve[i]);
    }
    return result;
}

bool coversEnough(const ToolMaskOutline& outline)
{
    std::vector<core::OutlineVertex> vertices;
    for (const glm::dvec2& point : outline) {
        const glm::dvec2 place = point * (0.5 * acrossElements * core::outlineSubdivision);
        vertices.emplace_back(int(std::lround(place.x)), int(std::lround(place.y)));
    }
    const double whole = 256.0 * acrossElements * acrossElements;
    return double(core::filledExactly(vertices).area()) >= leastShare * whole;
}

} // namespace

std::optional<DrawnToolMask> drawnToolMask(
    const std::vector<glm::dvec2>& curveMm, double toleranceMm)
{
    if (curveMm.size() < 3)
        return {};
    DrawnToolMask drawn{.outline = simplified(curveMm, toleranceMm)};
    glm::dvec2 low = drawn.outline.front();
    glm::dvec2 high = low;
    for (const glm::dvec2& point : drawn.outline) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    const double side = std::max(high.x - low.x, high.y - low.y);
    if (side < leastSideMm)
        return {};
    drawn.radiusMm = side / 2.0;
    for (glm::dvec2& point : drawn.outline)
        point = (point - (low + high) / 2.0) / drawn.radiusMm;
    if (!coversEnough(drawn.outline))
        return {};
    return drawn;
}

QJsonArray outlineJson(const ToolMaskOutline& outline)
{
    QJsonArray points;
    for (const glm::dvec2& point : outline)
        points.append(QJsonArray{point.x, point.y});
    return points;
}

ToolMaskOutline outlineFromJson(const QJsonValue& json)
{
    const QJsonArray points = json.toArray();
    if (points.size() < 3 || std::size_t(points.size()) > mostPoints)
        return {};
    ToolMaskOutline outline;
    for (const QJsonValue& each : points) {
        const QJsonArray point = each.toArray();
        const glm::dvec2 at(point[0].toDouble(std::nan("")), point[1].toDouble(std::nan("")));
        // Not a number is not within them either.
        const bool within =
            std::abs(at.x) <= 1.0 + roundingSlack && std::abs(at.y) <= 1.0 + roundingSlack;
        if (point.size() != 2 || !within)
            return {};
        outline.push_back(at);
    }
    return coversEnough(outline) ? outline : ToolMaskOutline();
}

} // namespace ui
