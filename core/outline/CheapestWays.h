// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/outline/SideCosts.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace core {

/// The cheapest ways along the sides of pixels from one corner, the anchor, to all others (Dijkstra
/// with whole costs, in buckets as Dial has it). They are worked out once; each way is then found
/// at the cost of its length, so that it can follow a pointer.
///
/// Which of several ways of the same cost is taken depends on costs and places alone: from the end
/// backwards, each step leads to the corner nearest to the straight line from the anchor to the
/// end, and among corners as near to the one on the right, below, on the left, above, in this
/// order.
class CheapestWays {
public:
    /// Farther than this from the anchor, along columns or rows, no way is sought, so that a large
    /// picture does not cost more than a moment.
    static constexpr int defaultReach = 1000;

    /// @pre the anchor is a corner of the costs
    CheapestWays(
        std::shared_ptr<const SideCosts> costs, const glm::ivec2& anchor, int reach = defaultReach);

    [[nodiscard]] const glm::ivec2& anchor() const { return m_anchor; }
    /// The sum of the costs of the sides. @pre the corner is within reach
    [[nodiscard]] std::uint32_t costTo(const glm::ivec2& corner) const;
    /// From the anchor to the corner: both ends, and the corners where it turns. Beyond the reach
    /// it runs straight. The anchor alone, if that is the corner.
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
    glm::ivec2 m_low; ///< of the corners within reach
    glm::ivec2 m_high; ///< the last of them
    std::vector<std::uint32_t> m_sums; ///< by corner within reach
};

} // namespace core
