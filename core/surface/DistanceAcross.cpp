// SPDX-License-Identifier: Apache-2.0
#include "core/surface/DistanceAcross.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace core {

namespace {

/// A longer distance must exceed the one already found by this factor. So rounding, and shapes with
/// the same width everywhere, do not make it compare everything.
constexpr double leastGain = 1.0 + 1e-9;
constexpr std::size_t manyEdges = 20000;

/// Seen along the direction.
struct Chord {
    glm::dvec2 from{0.0};
    glm::dvec2 to{0.0};
    double length = 0.0;
};

/// Points of a plane, or of a slab, seen along the direction; with a circle around them.
struct Shadow {
    std::vector<glm::dvec2> points{};
    glm::dvec2 middle{0.0};
    double radius = 0.0;

    void findCircle()
    {
        glm::dvec2 low(std::numeric_limits<double>::max());
        glm::dvec2 high(std::numeric_limits<double>::lowest());
        for (const glm::dvec2& point : points) {
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
        middle = (low + high) / 2.0;
        radius = 0.0;
        for (const glm::dvec2& point : points)
            radius = std::max(radius, glm::distance(point, middle));
    }
    /// Whether a point may be an end of a chord that exceeds a length.
    [[nodiscard]] bool reaches(const glm::dvec2& point, double length) const
    {
        return glm::distance(point, middle) + radius > length;
    }
    /// The corners of the smallest convex polygon around the points. (Andrew's monotone chain.)
    void reduceToHull()
    {
        if (points.size() < 3)
            return;
        std::sort(points.begin(), points.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
            return a.x != b.x ? a.x < b.x : a.y < b.y;
        });
        std::vector<glm::dvec2> hull;
        const auto turnsLeft = [&hull](const glm::dvec2& next) {
            const glm::dvec2 first = hull.back() - hull[hull.size() - 2];
            const glm::dvec2 second = next - hull.back();
            return first.x * second.y - first.y * second.x > 0.0;
        };
        const auto wrap = [&](auto begin, auto end) {
            const std::size_t fixed = hull.size() + 1;
            for (auto point = begin; point != end; ++point) {
                while (hull.size() > fixed && !turnsLeft(*point))
                    hull.pop_back();
                hull.push_back(*point);
            }
            hull.pop_back(); // the other side begins with it
        };
        wrap(points.begin(), points.end());
        wrap(points.rbegin(), points.rend());
        points = std::move(hull);
    }
};

/// The longest chord of a shadow, if it exceeds a length; else none is found. The points are used
/// up.
Chord longestChord(Shadow& shadow, double length)
{
    shadow.findCircle();
    std::erase_if(
        shadow.points, [&](const glm::dvec2& point) { return !shadow.reaches(point, length); });
    shadow.reduceToHull();
    Chord longest{.length = length};
    for (std::size_t i = 0; i < shadow.points.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const double between = glm::distance(shadow.points[i], shadow.points[k]);
            if (between > longest.length)
                longest = {.from = shadow.points[i], .to = shadow.points[k], .length = between};
        }
    }
    return longest.length > length ? longest : Chord{};
}

/// A surface in planes perpendicular to the direction.
class SurfaceSections {
public:
    SurfaceSections(std::span<const glm::dvec3> places, std::span<const glm::uvec3> triangles,
        const glm::dvec3& along)
        : m_origin(places.front())
        , m_along(glm::normalize(along))
    {
        const glm::dvec3 size = glm::abs(m_along);
        const glm::dvec3 aside = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
            : size.y <= size.z                                        ? glm::dvec3(0, 1, 0)
                                                                      : glm::dvec3(0, 0, 1);
        m_right = glm::normalize(glm::cross(m_along, aside));
        m_up = glm::cross(m_along, m_right);
        m_corners.reserve(places.size());
        for (const glm::dvec3& place : places) {
            const glm::dvec3 step = place - m_origin;
            m_corners.push_back({.height = glm::dot(step, m_along),
                .across = {glm::dot(step, m_right), glm::dot(step, m_up)}});
        }
        for (const glm::uvec3& triangle : triangles) {
            for (int side = 0; side < 3; ++side)
                addEdge(triangle[side], triangle[(side + 1) % 3]);
        }
    }

    LongestDistance widest()
    {
        std::vector<double> heights;
        heights.reserve(m_corners.size());
        for (const Corner& corner : m_corners)
            heights.push_back(corner.height);
        std::sort(heights.begin(), heights.end());
        heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
        m_heights = std::move(heights);
        const Slab whole{
            .low = 0, .high = m_heights.size() - 1, .edges = std::exchange(m_edges, {})};
        compareIn(whole.edges, m_heights.front());
        compareIn(whole.edges, m_heights.back());
        search(whole);
        return {.from = placeAt(m_longest.from), .to = placeAt(m_longest.to)};
    }

private:
    struct Corner {
        double height = 0.0;
        glm::dvec2 across{0.0};
    };
    struct Edge {
        std::uint32_t lower = 0;
        std::uint32_t upper = 0;
    };
    /// The part of the surface between two heights.
    struct Slab {
        std::size_t low = 0; ///< of `m_heights`
        std::size_t high = 0;
        std::vector<Edge> edges{}; ///< those that may have ends of a longer chord there
        double bound = 0.0; ///< no chord there is longer; 0: not longer than the one found
    };

    void addEdge(std::uint32_t from, std::uint32_t to)
    {
        if (from > to) // the other triangle has it the other way round
            return;
        const bool rises = m_corners[from].height <= m_corners[to].height;
        m_edges.push_back({.lower = rises ? from : to, .upper = rises ? to : from});
    }

    [[nodiscard]] glm::dvec3 placeAt(const glm::dvec2& across) const
    {
        return m_origin + m_height * m_along + across.x * m_right + across.y * m_up;
    }

    [[nodiscard]] glm::dvec2 pointAt(const Edge& edge, double height) const
    {
        const Corner& lower = m_corners[edge.lower];
        const Corner& upper = m_corners[edge.upper];
        if (height <= lower.height)
            return lower.across;
        if (height >= upper.height)
            return upper.across;
        return glm::mix(
            lower.across, upper.across, (height - lower.height) / (upper.height - lower.height));
    }

    /// Compares the points of one plane.
    void compareIn(const std::vector<Edge>& edges, double height)
    {
        Shadow section;
        for (const Edge& edge : edges) {
            const double lower = m_corners[edge.lower].height;
            const double upper = m_corners[edge.upper].height;
            if (lower > height || upper < height)
                continue;
            section.points.push_back(pointAt(edge, height));
            if (lower == upper)
                section.points.push_back(m_corners[edge.upper].across);
        }
        if (const Chord found = longestChord(section, m_longest.length); found.length > 0.0) {
            m_longest = found;
            m_height = height;
        }
    }

    /// The part of a slab between two of its heights.
    [[nodiscard]] Slab partOf(const Slab& slab, std::size_t low, std::size_t high) const
    {
        Slab part{.low = low, .high = high};
        if (high - low < 2) // planes at both ends were compared, and there is none between them
            return part;
        Shadow shadow;
        for (const Edge& edge : slab.edges) {
            if (m_corners[edge.lower].height > m_heights[high]
                || m_corners[edge.upper].height < m_heights[low])
                continue;
            part.edges.push_back(edge);
            shadow.points.push_back(pointAt(edge, m_heights[low]));
            shadow.points.push_back(pointAt(edge, m_heights[high]));
        }
        shadow.findCircle();
        const double wanted = m_longest.length * leastGain;
        // The ends of what lies between both heights are the farthest from the middle.
        std::size_t kept = 0;
        for (std::size_t i = 0; i < part.edges.size(); ++i) {
            if (shadow.reaches(shadow.points[2 * i], wanted)
                || shadow.reaches(shadow.points[2 * i + 1], wanted))
                part.edges[kept++] = part.edges[i];
        }
        part.edges.resize(kept);
        part.edges.shrink_to_fit();
        // Dividing further costs less than to sort so many points.
        part.bound = kept > manyEdges ? 2.0 * shadow.radius : longestChord(shadow, wanted).length;
        return part;
    }

    /// Compares the planes between both ends of a slab.
    void search(const Slab& slab)
    {
        if (slab.high - slab.low < 2)
            return;
        const std::size_t middle = slab.low + (slab.high - slab.low) / 2;
        compareIn(slab.edges, m_heights[middle]);
        std::array<Slab, 2> parts{partOf(slab, slab.low, middle), partOf(slab, middle, slab.high)};
        if (parts[0].bound < parts[1].bound)
            std::swap(parts[0], parts[1]);
        for (Slab& part : parts) {
            if (part.bound > m_longest.length * leastGain)
                search(part);
            part = {};
        }
    }

    glm::dvec3 m_origin;
    glm::dvec3 m_along;
    glm::dvec3 m_right{0.0};
    glm::dvec3 m_up{0.0};
    std::vector<Corner> m_corners;
    std::vector<Edge> m_edges;
    std::vector<double> m_heights;
    Chord m_longest;
    double m_height = 0.0; ///< of the longest chord
};

} // namespace

LongestDistance distanceAcross(std::span<const glm::dvec3> places,
    std::span<const glm::uvec3> triangles, const glm::dvec3& along)
{
    if (triangles.empty() || glm::dot(along, along) <= 0.0)
        return {};
    return SurfaceSections(places, triangles, along).widest();
}

} // namespace core
