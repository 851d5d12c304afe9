// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// An undirected graph, as lists of neighbours.
struct PassageGraph {
    std::vector<std::uint32_t> first{0}; ///< of each node in `next`; one more than there are nodes
    std::vector<std::uint32_t> next{};
    std::vector<bool> source{};
    std::vector<bool> sink{};

    [[nodiscard]] std::uint32_t size() const { return std::uint32_t(source.size()); }
};

/// The smallest set of nodes without which no path leads from a source to a sink (a minimum vertex
/// cut); sources and sinks may be in it. Of several such sets it returns the unique one that is
/// nearest to the sources. Ascending.
[[nodiscard]] std::vector<std::uint32_t> narrowestCut(const PassageGraph& graph);

} // namespace core
