// SPDX-License-Identifier: Apache-2.0
#include "core/surface/SliceContours.h"

#include <algorithm>
#include <array>

namespace core {

namespace {

/// East, south, west, north; rows grow to the south. Turning right is one further.
constexpr std::array<glm::ivec2, 4> steps{
    glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(-1, 0), glm::ivec2(0, -1)};

struct Node {
    glm::ivec2 corner;
    int next = -1;
};

/// A loop of borders with its pixels at the right hand.
struct Loop {
    int start = 0; ///< of a hole its leftmost node, of those the uppermost
    bool isHole = false;
};

class Tracer {
public:
    Tracer(std::span<const std::uint8_t> labels, std::uint8_t label, const glm::ivec2& size)
        : m_labels(labels)
        , m_label(label)
        , m_size(size)
        , m_corners(size + 1)
    {
    }

    std::vector<SliceContour> trace()
    {
        findBorders();
        std::vector<Loop> outer;
        std::vector<Loop> holes;
        for (std::size_t corner = 0; corner < m_untrodden.size(); ++corner) {
            while (m_untrodden[corner] != 0) {
                const Loop loop = walk({int(corner % std::size_t(m_corners.x)),
                    int(corner / std::size_t(m_corners.x))});
                (loop.isHole ? holes : outer).push_back(loop);
            }
        }
        // From the left, so that what a hole is joined to belongs to an outer loop by then.
        std::sort(holes.begin(), holes.end(), [this](const Loop& a, const Loop& b) {
            return leftOf(
                m_nodes[std::size_t(a.start)].corner, m_nodes[std::size_t(b.start)].corner);
        });
        for (const Loop& hole : holes)
            join(hole);
        std::vector<SliceContour> contours;
        contours.reserve(outer.size());
        for (const Loop& loop : outer)
            contours.push_back(withoutStraightOnes(loop.start));
        return contours;
    }

private:
    static bool leftOf(const glm::ivec2& a, const glm::ivec2& b)
    {
        return a.x != b.x ? a.x < b.x : a.y < b.y;
    }
    [[nodiscard]] bool inside(int x, int y) const
    {
        return x >= 0 && y >= 0 && x < m_size.x && y < m_size.y
            && m_labels[std::size_t(y) * std::size_t(m_size.x) + std::size_t(x)] == m_label;
    }
    [[nodiscard]] std::size_t at(const glm::ivec2& corner) const
    {
        return std::size_t(corner.y) * std::size_t(m_corners.x) + std::size_t(corner.x);
    }

    /// Which ways lead on from each corner.
    void findBorders()
    {
        const std::size_t count = std::size_t(m_corners.x) * std::size_t(m_corners.y);
        m_ways.assign(count, 0);
        m_nodeAt.assign(count, -1);
        for (int y = 0; y < m_corners.y; ++y) {
            for (int x = 0; x < m_corners.x; ++x) {
                const bool northWest = inside(x - 1, y - 1);
                const bool northEast = inside(x, y - 1);
                const bool southWest = inside(x - 1, y);
                const bool southEast = inside(x, y);
                const int ways = (southEast && !northEast ? 1 : 0)
                    | (southWest && !southEast ? 2 : 0) | (northWest && !southWest ? 4 : 0)
                    | (northEast && !northWest ? 8 : 0);
                m_ways[at({x, y})] = std::uint8_t(ways);
            }
        }
        m_untrodden = m_ways;
    }

    /// Where two ways lead on, the one to the right stays with the same pixel.
    [[nodiscard]] int wayFrom(const glm::ivec2& corner, int way) const
    {
        const int ways = m_ways[at(corner)];
        const int right = (way + 1) % 4;
        const int left = (way + 3) % 4;
        if ((ways & (1 << right)) != 0)
            return right;
        return (ways & (1 << way)) != 0 ? way : left;
    }

    Loop walk(const glm::ivec2& first)
    {
        Loop loop{.start = int(m_nodes.size())};
        const int begin = loop.start;
        std::int64_t twiceTheArea = 0;
        glm::ivec2 corner = first;
        int way = 0;
        while ((m_untrodden[at(first)] & (1 << way)) == 0)
            ++way;
        while ((m_untrodden[at(corner)] & (1 << way)) != 0) {
            m_untrodden[at(corner)] &= std::uint8_t(~(1 << way));
            const int node = int(m_nodes.size());
            m_nodes.push_back({.corner = corner, .next = node + 1});
            m_nodeAt[at(corner)] = node;
            if (leftOf(corner, m_nodes[std::size_t(loop.start)].corner))
                loop.start = node;
            const glm::ivec2 next = corner + steps[std::size_t(way)];
            twiceTheArea += std::int64_t(corner.x) * next.y - std::int64_t(next.x) * corner.y;
            corner = next;
            way = wayFrom(corner, way);
        }
        m_nodes.back().next = begin;
        loop.isHole = twiceTheArea < 0;
        return loop;
    }

    /// Hangs a hole on what lies to the left of its leftmost corner: there are only pixels between.
    void join(const Loop& hole)
    {
        const Node entry = m_nodes[std::size_t(hole.start)];
        glm::ivec2 corner = entry.corner;
        do {
            --corner.x;
        } while (m_nodeAt[at(corner)] < 0);
        const int gate = m_nodeAt[at(corner)];
        const int copyOfGate = int(m_nodes.size());
        const int copyOfEntry = copyOfGate + 1;
        m_nodes.push_back(m_nodes[std::size_t(gate)]);
        m_nodes.push_back(entry);
        m_nodes[std::size_t(gate)].next = copyOfEntry;
        m_nodes[std::size_t(hole.start)].next = copyOfGate;
    }

    [[nodiscard]] SliceContour withoutStraightOnes(int start) const
    {
        SliceContour contour;
        const auto node = [this](int index) -> const Node& { return m_nodes[std::size_t(index)]; };
        int before = start;
        int here = node(start).next;
        const int first = here;
        do {
            const int next = node(here).next;
            const glm::ivec2 in = glm::sign(node(here).corner - node(before).corner);
            const glm::ivec2 out = glm::sign(node(next).corner - node(here).corner);
            if (in != out)
                contour.push_back(node(here).corner);
            before = here;
            here = next;
        } while (here != first);
        return contour;
    }

    std::span<const std::uint8_t> m_labels;
    std::uint8_t m_label;
    glm::ivec2 m_size;
    glm::ivec2 m_corners;
    std::vector<std::uint8_t> m_ways; ///< a bit for each step that leads on from a corner
    std::vector<std::uint8_t> m_untrodden;
    std::vector<int> m_nodeAt; ///< a node of each corner; -1: none
    std::vector<Node> m_nodes;
};

} // namespace

std::vector<SliceContour> sliceContours(
    std::span<const std::uint8_t> labels, std::uint8_t label, const glm::ivec2& size)
{
    return Tracer(labels, label, size).trace();
}

} // namespace core
