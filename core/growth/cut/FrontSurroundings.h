// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/WordBricks.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace core {

/// The members around a front, in order of their distance from it in steps: where the narrowest cut
/// is searched for (GrowthCut.h, rule 8). Nodes are numbered in that order.
class FrontSurroundings {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFFu;

    /// @param front not empty, all of them members
    FrontSurroundings(const WordBricks& words, const std::vector<WordBricks::Voxel>& front,
        const std::function<bool(std::uint32_t word)>& isMember);

    [[nodiscard]] const std::vector<WordBricks::Voxel>& voxels() const { return m_voxels; }
    /// Whether it lies as many steps from the front as are searched.
    [[nodiscard]] bool isFarthest(std::size_t node) const { return m_steps[node] == m_farthest; }
    [[nodiscard]] std::uint32_t nodeAt(const glm::ivec3& place) const;

private:
    [[nodiscard]] std::size_t slotOf(const glm::ivec3& place) const; ///< inside the box

    VoxelBox m_box;
    int m_farthest = 0;
    std::vector<std::uint32_t> m_nodes; ///< of each voxel of the box
    std::vector<WordBricks::Voxel> m_voxels; ///< of each node
    std::vector<int> m_steps;
};

} // namespace core
