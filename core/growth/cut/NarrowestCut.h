// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// A graph without directions: who is next to whom.
struct PassageGraph {
    std::vector<std::uint32_t> first{0}; ///< of each node in `next`; one more than there are nodes
    std::vector<std::uint32_t> next{};
    std::vector<bool> source{};
    std::vector<bool> sink{};

    [[nodiscard]] std::uint32_t size() const { return std::uint32_t(source.size()); }
};

/// The smallest set of nodes without which no way leads from a source to a sink; sources and sinks
/// may be in it. Of several it is the one nearest to the sources, and unique. Ascending.
[[nodiscard]] std::vector<std::uint32_t> narrowestCut(const PassageGraph& graph);

} // namespace core
