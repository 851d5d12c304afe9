// SPDX-License-Identifier: Apache-2.0
#include "core/surface/LongestDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace core {

namespace {

constexpr std::size_t pointsOfALeaf = 16;
/// Bounds are computed with rounding errors, so they are enlarged a little.
constexpr double boundSlack = 1.0 + 1e-9;

double squaredDistance(const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 apart = a - b;
    return glm::dot(apart, apart);
}

/// A tree of boxes, each of which holds a range of the points.
class BoxTree {
public:
    explicit BoxTree(std::vector<glm::dvec3> points)
        : m_points(std::move(points))
    {
        glm::dvec3 low(std::numeric_limits<double>::max());
        glm::dvec3 high(std::numeric_limits<double>::lowest());
        for (const glm::dvec3& point : m_points) {
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
        m_middle = (low + high) / 2.0;
        build(0, m_points.size());
    }

    LongestDistance longest()
    {
        m_found = {.from = m_points.front(), .to = m_points.front()};
        startFromFarPoints();
        compare(0, 0);
        return m_found;
    }

private:
    struct Node {
        glm::dvec3 low{0.0};
        glm::dvec3 high{0.0};
        double farthest = 0.0; ///< of its points from the middle of all
        std::size_t begin = 0;
        std::size_t end = 0;
        std::size_t left = 0; ///< of children; 0: it is a leaf
        std::size_t right = 0;
    };

    std::size_t build(std::size_t begin, std::size_t end)
    {
        const std::size_t at = m_nodes.size();
        Node node{.begin = begin, .end = end};
        node.low = node.high = m_points[begin];
        for (std::size_t i = begin; i < end; ++i) {
            node.low = glm::min(node.low, m_points[i]);
            node.high = glm::max(node.high, m_points[i]);
            node.farthest = std::max(node.farthest, squaredDistance(m_points[i], m_middle));
        }
        node.farthest = std::sqrt(node.farthest);
        m_nodes.push_back(node);
        if (end - begin <= pointsOfALeaf)
            return at;
        const glm::dvec3 sides = node.high - node.low;
        const int axis = sides.x >= sides.y && sides.x >= sides.z ? 0 : sides.y >= sides.z ? 1 : 2;
        const std::size_t half = begin + (end - begin) / 2;
        const auto place = [&](std::size_t i) { return m_points.begin() + std::ptrdiff_t(i); };
        std::nth_element(place(begin), place(half), place(end),
            [axis](const glm::dvec3& a, const glm::dvec3& b) { return a[axis] < b[axis]; });
        const std::size_t left = build(begin, half);
        const std::size_t right = build(half, end);
        m_nodes[at].left = left;
        m_nodes[at].right = right;
        return at;
    }

    void take(const glm::dvec3& from, const glm::dvec3& to)
    {
        const double squared = squaredDistance(from, to);
        if (squared <= m_best)
            return;
        m_best = squared;
        m_found = {.from = from, .to = to};
    }

    /// Goes from a point to the point farthest from it, several times. This yields a long distance
    /// at the start, so that many pairs can be skipped.
    void startFromFarPoints()
    {
        glm::dvec3 from = m_points.front();
        for (int step = 0; step < 4; ++step) {
            const glm::dvec3 next = *std::max_element(
                m_points.begin(), m_points.end(), [&](const glm::dvec3& a, const glm::dvec3& b) {
                    return squaredDistance(a, from) < squaredDistance(b, from);
                });
            take(from, next);
            from = next;
        }
    }

    /// The square of a distance that no point of one box exceeds to a point of the other.
    [[nodiscard]] double bound(const Node& a, const Node& b) const
    {
        const glm::dvec3 widest = glm::max(glm::abs(a.high - b.low), glm::abs(b.high - a.low));
        const double byMiddle = a.farthest + b.farthest;
        return std::min(glm::dot(widest, widest), byMiddle * byMiddle) * boundSlack;
    }

    void compare(std::size_t first, std::size_t second)
    {
        const Node& a = m_nodes[first];
        const Node& b = m_nodes[second];
        if (bound(a, b) <= m_best)
            return;
        if (a.left == 0 && b.left == 0) {
            for (std::size_t i = a.begin; i < a.end; ++i) {
                for (std::size_t k = b.begin; k < b.end; ++k)
                    take(m_points[i], m_points[k]);
            }
            return;
        }
        if (first == second) {
            compare(a.left, a.right);
            compare(a.left, a.left);
            compare(a.right, a.right);
            return;
        }
        // The one with more points is divided; of its halves the one that promises more comes
        // first.
        const bool dividesFirst =
            b.left == 0 || (a.left != 0 && a.end - a.begin >= b.end - b.begin);
        const Node& divided = dividesFirst ? a : b;
        const std::size_t other = dividesFirst ? second : first;
        std::size_t sooner = divided.left;
        std::size_t later = divided.right;
        if (bound(m_nodes[later], m_nodes[other]) > bound(m_nodes[sooner], m_nodes[other]))
            std::swap(sooner, later);
        compare(sooner, other);
        compare(later, other);
    }

    std::vector<glm::dvec3> m_points;
    std::vector<Node> m_nodes;
    glm::dvec3 m_middle{0.0};
    double m_best = 0.0; ///< the square of the longest distance found
    LongestDistance m_found{};
};

} // namespace

LongestDistance longestDistance(std::vector<glm::dvec3> points)
{
    if (points.empty())
        return {};
    return BoxTree(std::move(points)).longest();
}

} // namespace core
