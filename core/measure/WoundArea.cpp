// SPDX-License-Identifier: Apache-2.0
#include "core/measure/WoundArea.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

/// An edge that is not along x, from below to above.
struct RisingEdge {
    glm::dvec2 low;
    glm::dvec2 high;
    int turn = 0; ///< 1: the outline runs upwards here, -1: downwards

    [[nodiscard]] double xAt(double y) const
    {
        return low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
    }
};

std::vector<RisingEdge> risingEdges(const std::vector<glm::dvec2>& polygon)
{
    std::vector<RisingEdge> edges;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 from = polygon[i];
        const glm::dvec2 to = polygon[(i + 1) % polygon.size()];
        if (from.y < to.y)
            edges.push_back({from, to, 1});
        else if (to.y < from.y)
            edges.push_back({to, from, -1});
    }
    return edges;
}

/// The heights of all corners and crossings, ascending: between two of them no edge ends and none
/// crosses another.
std::vector<double> levelsOf(
    const std::vector<glm::dvec2>& polygon, const std::vector<RisingEdge>& edges)
{
    std::vector<double> levels;
    for (const glm::dvec2& corner : polygon)
        levels.push_back(corner.y);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const glm::dvec2 along = edges[i].high - edges[i].low;
        for (std::size_t k = i + 1; k < edges.size(); ++k) {
            const glm::dvec2 other = edges[k].high - edges[k].low;
            const double turn = cross(along, other);
            if (turn == 0.0)
                continue;
            const glm::dvec2 between = edges[k].low - edges[i].low;
            const double onFirst = cross(between, other) / turn;
            const double onSecond = cross(between, along) / turn;
            if (onFirst > 0.0 && onFirst < 1.0 && onSecond > 0.0 && onSecond < 1.0)
                levels.push_back(edges[i].low.y + onFirst * along.y);
        }
    }
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    return levels;
}

bool liesOn(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& place)
{
    const glm::dvec2 along = to - from;
    const double length = glm::dot(along, along);
    const double share =
        length > 0.0 ? std::clamp(glm::dot(place - from, along) / length, 0.0, 1.0) : 0.0;
    constexpr double nearMm = 1e-9;
    return glm::distance(place, from + share * along) <= nearMm;
}

} // namespace

std::vector<Trapezoid> woundTrapezoids(const std::vector<glm::dvec2>& polygon)
{
    const std::vector<RisingEdge> edges = risingEdges(polygon);
    const std::vector<double> levels = levelsOf(polygon, edges);
    std::vector<Trapezoid> inside;
    std::vector<std::pair<double, const RisingEdge*>> met;
    for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
        const double low = levels[i];
        const double high = levels[i + 1];
        met.clear();
        for (const RisingEdge& edge : edges) {
            if (edge.low.y <= low && edge.high.y >= high)
                met.emplace_back(edge.xAt((low + high) / 2.0), &edge);
        }
        std::sort(
            met.begin(), met.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        int winding = 0;
        for (std::size_t k = 0; k + 1 < met.size(); ++k) {
            winding += met[k].second->turn;
            if (winding == 0)
                continue;
            const RisingEdge& left = *met[k].second;
            const RisingEdge& right = *met[k + 1].second;
            inside.push_back({glm::dvec2(left.xAt(low), low), glm::dvec2(right.xAt(low), low),
                glm::dvec2(right.xAt(high), high), glm::dvec2(left.xAt(high), high)});
        }
    }
    return inside;
}

double woundArea(const std::vector<glm::dvec2>& polygon)
{
    double area = 0.0;
    for (const Trapezoid& each : woundTrapezoids(polygon))
        area += (each[1].x - each[0].x + each[2].x - each[3].x) / 2.0 * (each[2].y - each[1].y);
    return area;
}

bool isWound(const std::vector<glm::dvec2>& polygon, const glm::dvec2& place)
{
    int winding = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 from = polygon[i];
        const glm::dvec2 to = polygon[(i + 1) % polygon.size()];
        if (liesOn(from, to, place))
            return true;
        const double side = cross(to - from, place - from);
        if (from.y <= place.y && to.y > place.y && side > 0.0)
            ++winding;
        else if (to.y <= place.y && from.y > place.y && side < 0.0)
            --winding;
    }
    return winding != 0;
}

} // namespace core
