// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <set>
#include <unordered_map>
#include <vector>

namespace reference {

/// A flow network; arcs are added with their capacity, and what flows is kept as capacity of the
/// way back. Places are numbered as they come. Fills all shortest ways before it looks for longer
/// ones (Dinic): wide growths have hundreds of ways through millions of arcs.
class FlowNetwork {
public:
    void add(std::size_t from, std::size_t to, int capacity);
    /// Lets as much through as goes.
    void fill(std::size_t source, std::size_t sink);
    /// The places to which more would get through from the source.
    [[nodiscard]] std::set<std::size_t> reached(std::size_t source);

private:
    static constexpr int unreached = -1;
    struct Edge {
        std::size_t to = 0;
        int left = 0;
        std::size_t back = 0; ///< place of the opposite edge there
    };

    std::size_t number(std::size_t place);
    [[nodiscard]] std::vector<int> stepsFrom(std::size_t source) const;
    /// One more unit by a shortest way; edges that lead nowhere are not tried again.
    bool push(std::size_t first, std::size_t last);

    std::unordered_map<std::size_t, std::size_t> m_numbers;
    std::vector<std::vector<Edge>> m_edges;
    std::vector<int> m_steps; ///< from the source, as the ways were when last looked for
    std::vector<std::size_t> m_tried; ///< of each place's edges
};

} // namespace reference
