// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/NarrowestCut.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

// As many ways as can be found that share no node: every smallest cut has one node of each. Ways
// are sought level by level (Dinic). A node has two states, entered (even) and left (odd): between
// them it is used by one way at most.
class DisjointWays {
public:
    explicit DisjointWays(const PassageGraph& graph)
        : m_graph(graph)
        , m_before(graph.size(), nobody)
        , m_after(graph.size(), nobody)
        , m_level(2 * std::size_t(graph.size()))
        , m_tried(2 * std::size_t(graph.size()))
    {
    }

    void findAll()
    {
        while (setLevels()) {
            std::fill(m_tried.begin(), m_tried.end(), 0);
            for (std::uint32_t node = 0; node < m_graph.size(); ++node) {
                if (m_graph.source[node])
                    extendFrom(2 * node);
            }
        }
    }

    /// Once all are found: nodes that are entered from the sources but not left.
    [[nodiscard]] std::vector<std::uint32_t> cut() const
    {
        std::vector<std::uint32_t> nodes;
        for (std::uint32_t node = 0; node < m_graph.size(); ++node) {
            if (m_level[2 * node] != unreached && m_level[2 * node + 1] == unreached)
                nodes.push_back(node);
        }
        return nodes;
    }

private:
    static constexpr std::uint32_t nobody = 0xFFFFFFFFu;
    static constexpr std::uint32_t theEnd = 0xFFFFFFFEu; ///< a way begins or ends here
    static constexpr std::uint32_t unreached = 0xFFFFFFFFu;

    [[nodiscard]] bool used(std::uint32_t node) const { return m_before[node] != nobody; }
    [[nodiscard]] bool canEnd(std::uint32_t state) const
    {
        return state % 2 == 1 && m_graph.sink[state / 2] && m_after[state / 2] != theEnd;
    }
    [[nodiscard]] std::uint32_t moves(std::uint32_t state) const
    {
        const std::uint32_t node = state / 2;
        return state % 2 == 0 ? 1 : 1 + m_graph.first[node + 1] - m_graph.first[node];
    }
    /// Where a move leads; `unreached` where it may not be done.
    [[nodiscard]] std::uint32_t target(std::uint32_t state, std::uint32_t move) const
    {
        const std::uint32_t node = state / 2;
        if (state % 2 == 0) {
            if (!used(node))
                return state + 1;
            return m_before[node] == theEnd ? unreached : 2 * m_before[node] + 1;
        }
        if (move == 0)
            return used(node) ? state - 1 : unreached;
        const std::uint32_t next = m_graph.next[m_graph.first[node] + move - 1];
        return m_after[node] == next ? unreached : 2 * next;
    }

    /// @return whether one more way can be found
    bool setLevels()
    {
        std::fill(m_level.begin(), m_level.end(), unreached);
        std::vector<std::uint32_t> queue;
        for (std::uint32_t node = 0; node < m_graph.size(); ++node) {
            if (m_graph.source[node]) {
                m_level[2 * node] = 0;
                queue.push_back(2 * node);
            }
        }
        bool ends = false;
        for (std::size_t head = 0; head < queue.size(); ++head) {
            const std::uint32_t state = queue[head];
            ends = ends || canEnd(state);
            for (std::uint32_t move = 0; move < moves(state); ++move) {
                const std::uint32_t to = target(state, move);
                if (to == unreached || m_level[to] != unreached)
                    continue;
                m_level[to] = m_level[state] + 1;
                queue.push_back(to);
            }
        }
        return ends;
    }

    void extendFrom(std::uint32_t start)
    {
        std::vector<std::uint32_t> way{start};
        while (!way.empty()) {
            const std::uint32_t state = way.back();
            if (canEnd(state)) {
                take(way);
                return;
            }
            bool moved = false;
            while (!moved && m_tried[state] < moves(state)) {
                const std::uint32_t to = target(state, m_tried[state]++);
                moved = to != unreached && m_level[to] == m_level[state] + 1;
                if (moved)
                    way.push_back(to);
            }
            if (!moved) {
                m_level[state] = dead;
                way.pop_back();
            }
        }
    }

    void take(const std::vector<std::uint32_t>& way)
    {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;
        for (std::size_t i = 0; i + 1 < way.size(); ++i) {
            const std::uint32_t from = way[i] / 2;
            const std::uint32_t to = way[i + 1] / 2;
            if (from == to)
                continue;
            if (way[i] % 2 == 1) {
                joined.emplace_back(from, to);
            } else {
                m_after[to] = nobody;
                m_before[from] = nobody;
            }
        }
        for (const auto& [from, to] : joined) {
            m_after[from] = to;
            m_before[to] = from;
        }
        m_before[way.front() / 2] = theEnd;
        m_after[way.back() / 2] = theEnd;
        for (const std::uint32_t state : way)
            m_level[state] = dead;
    }

    static constexpr std::uint32_t dead = 0xFFFFFFFEu;

    const PassageGraph& m_graph;
    std::vector<std::uint32_t> m_before; ///< of each node on the way that uses it
    std::vector<std::uint32_t> m_after;
    std::vector<std::uint32_t> m_level; ///< of each state
    std::vector<std::uint32_t> m_tried; ///< moves of each state
};

} // namespace

std::vector<std::uint32_t> narrowestCut(const PassageGraph& graph)
{
    DisjointWays ways(graph);
    ways.findAll();
    return ways.cut();
}

} // namespace core
