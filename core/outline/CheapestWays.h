// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/outline/SideCosts.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace core {

/// The cheapest paths along the sides of pixels from one corner, the anchor, to all others
/// (livewire: Dijkstra's algorithm with whole costs, in buckets as by Dial). They are computed
/// once; finding a path then costs ∝ its length, so that it can follow the pointer.
///
/// Among several paths of the same cost, costs and positions alone decide: from the end backwards,
/// each step leads to the corner that is nearest to the straight line from the anchor to the end;
/// of equally near ones to that on the right, below, on the left, above, in this order.
class CheapestWays {
public:
    /// No path is computed farther than this from the anchor, in columns or rows, so that even for
    /// a large picture the computation takes only a moment.
    static constexpr int defaultReach = 1000;

    /// Computes all paths within reach.
    /// @pre the anchor is a corner of the costs
    CheapestWays(
        std::shared_ptr<const SideCosts> costs, const glm::ivec2& anchor, int reach = defaultReach);

    [[nodiscard]] const glm::ivec2& anchor() const { return m_anchor; }
    /// The cost of the path to a corner: the sum over its sides.
    /// @pre the corner is within reach
    [[nodiscard]] std::uint32_t costTo(const glm::ivec2& corner) const;
    /// The path from the anchor to a corner: both ends, and the corners where it turns. Beyond the
    /// reach it continues straight to the corner. Only the anchor, if it is that corner.
    [[nodiscard]] std::vector<glm::ivec2> wayTo(const glm::ivec2& corner) const;

private:
    [[nodiscard]] std::size_t at(const glm::ivec2& corner) const
    {
        const glm::ivec2 inBox = corner - m_low;
        return std::size_t(inBox.y) * std::size_t(m_high.x - m_low.x + 1) + std::size_t(inBox.x);
    }
    /// @param direction one of four: right, down, left, up
    [[nodiscard]] bool leadsOn(const glm::ivec2& corner, int direction) const;
    [[nodiscard]] std::uint32_t costOf(const glm::ivec2& corner, int direction) const;
    void spread();

    std::shared_ptr<const SideCosts> m_costs;
    glm::ivec2 m_anchor;
    glm::ivec2 m_low; ///< first of the corners within reach
    glm::ivec2 m_high; ///< the last of them
    std::vector<std::uint32_t> m_sums; ///< for each corner within reach, the cost of its path
};

} // namespace core
