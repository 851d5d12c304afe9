// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/Passage.h"
#include "core/growth/coarse/CoarseGrid.h"

#include <cstdint>
#include <vector>

namespace core {

/// Where a ball has room to roll, in cells (Passage.h has the rule in voxels). If the grid is
/// exact, a ball is that of the rule. In cells the border of what is open is known to half a cell,
/// and so is the width of a passage.
class CoarsePassage {
public:
    CoarsePassage(const Passage& passage, const CoarseGrid& grid);

    /// Whether a width is asked for, and a ball of it reaches further than its own cell along all
    /// axes. Else the cells are too large, and nothing below makes sense.
    [[nodiscard]] bool isTold() const { return m_isTold; }
    /// The cells around which a ball has room. Cost ∝ the cells, and the width in cells.
    /// @param open by cell: 1 or 0
    [[nodiscard]] std::vector<std::uint8_t> centres(const std::vector<std::uint8_t>& open) const;
    /// The cells in the balls around these, of which some may not be open. Cost as above.
    [[nodiscard]] std::vector<std::uint8_t> covered(const std::vector<std::uint8_t>& centres) const;
    /// From a cell to those whose balls hold it.
    [[nodiscard]] const std::vector<glm::ivec3>& steps() const { return m_steps; }

private:
    /// The square of each cell's distance from the nearest of these, as far as @p most.
    [[nodiscard]] std::vector<std::uint32_t> squaresFrom(
        const std::vector<std::uint8_t>& cells, std::uint32_t most) const;

    CoarseGrid m_grid;
    glm::ivec3 m_sides{0}; ///< of a cell, in units of the passage
    std::uint32_t m_room = 0; ///< the square of a ball's radius, for its room
    std::uint32_t m_reach = 0; ///< the same for what it covers
    bool m_isTold = false;
    std::vector<glm::ivec3> m_steps;
};

} // namespace core
