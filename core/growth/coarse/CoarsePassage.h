// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/Passage.h"
#include "core/growth/coarse/CoarseGrid.h"

#include <cstdint>
#include <vector>

namespace core {

/// Where a ball has room to roll, in cells (Passage.h has the rule in voxels). On an exact grid the
/// balls are those of the rule; on a coarser one the width of a passage is known only to half a
/// cell.
class CoarsePassage {
public:
    CoarsePassage(const Passage& passage, const CoarseGrid& grid);

    /// Whether a width is requested and its ball extends beyond its own cell along all axes. If
    /// not, the cells are too large and the functions below must not be used.
    [[nodiscard]] bool isTold() const { return m_isTold; }
    /// The cells around which a ball has room. Cost ∝ the cells, and the width in cells.
    /// @param open by cell: 1 or 0
    [[nodiscard]] std::vector<std::uint8_t> centres(const std::vector<std::uint8_t>& open) const;
    /// The cells covered by the balls around these centres; some of them may not be open. Cost as
    /// above.
    [[nodiscard]] std::vector<std::uint8_t> covered(const std::vector<std::uint8_t>& centres) const;
    /// The steps from a cell to the centres whose balls contain it.
    [[nodiscard]] const std::vector<glm::ivec3>& steps() const { return m_steps; }

private:
    /// For each cell the squared distance to the nearest of these, in units of the passage; @p most
    /// + 1 if it is greater than @p most.
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
