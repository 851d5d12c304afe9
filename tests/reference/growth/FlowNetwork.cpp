// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/growth/FlowNetwork.h"

namespace reference {

void FlowNetwork::add(std::size_t from, std::size_t to, int capacity)
{
    const std::size_t a = number(from);
    const std::size_t b = number(to);
    m_edges[a].push_back({.to = b, .left = capacity, .back = m_edges[b].size()});
    m_edges[b].push_back({.to = a, .left = 0, .back = m_edges[a].size() - 1});
}

void FlowNetwork::fill(std::size_t source, std::size_t sink)
{
    const std::size_t first = number(source);
    const std::size_t last = number(sink);
    for (;;) {
        m_steps = stepsFrom(first);
        if (m_steps[last] == unreached)
            return;
        m_tried.assign(m_edges.size(), 0);
        while (push(first, last)) { }
    }
}

std::set<std::size_t> FlowNetwork::reached(std::size_t source)
{
    const std::vector<int> steps = stepsFrom(number(source));
    std::set<std::size_t> places;
    for (const auto& [place, number] : m_numbers) {
        if (steps[number] != unreached)
            places.insert(place);
    }
    return places;
}

std::size_t FlowNetwork::number(std::size_t place)
{
    const auto [found, isNew] = m_numbers.emplace(place, m_numbers.size());
    if (isNew)
        m_edges.emplace_back();
    return found->second;
}

std::vector<int> FlowNetwork::stepsFrom(std::size_t source) const
{
    std::vector<int> steps(m_edges.size(), unreached);
    steps[source] = 0;
    std::vector<std::size_t> queue{source};
    for (std::size_t next = 0; next < queue.size(); ++next) {
        const std::size_t at = queue[next];
        for (const Edge& edge : m_edges[at]) {
            if (edge.left <= 0 || steps[edge.to] != unreached)
                continue;
            steps[edge.to] = steps[at] + 1;
            queue.push_back(edge.to);
        }
    }
    return steps;
}

bool FlowNetwork::push(std::size_t first, std::size_t last)
{
    std::vector<std::size_t> way; // the places before the present one
    for (std::size_t at = first; at != last;) {
        std::vector<Edge>& edges = m_edges[at];
        std::size_t& tried = m_tried[at];
        while (tried < edges.size()
            && (edges[tried].left <= 0 || m_steps[edges[tried].to] != m_steps[at] + 1))
            ++tried;
        if (tried < edges.size()) {
            way.push_back(at);
            at = edges[tried].to;
            continue;
        }
        if (way.empty())
            return false;
        at = way.back();
        way.pop_back();
        ++m_tried[at];
    }
    for (const std::size_t at : way) {
        Edge& edge = m_edges[at][m_tried[at]];
        --edge.left;
        ++m_edges[edge.to][edge.back].left;
    }
    return true;
}

} // namespace reference
