// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/brick/VoxelRuns.h"
#include "core/sculpt/labels/LayerWrites.h"

#include <bitset>
#include <cstdint>
#include <map>
#include <vector>

namespace core {

/// Collects runs of voxels and turns them into a command of an engine, which lists voxels brick by
/// brick.
class ListedRuns {
public:
    explicit ListedRuns(const glm::ivec3& volumeSize);

    /// @param asked what is requested for these voxels: for relabel() RelabelListed::give or take;
    /// for label() a label, or the number given there as `frees`
    void add(const VoxelRuns& runs, std::uint8_t asked);
    /// A command with everything that was added. Afterwards this object is empty.
    [[nodiscard]] RelabelListed relabel(LabelTarget target);
    /// The same if add() was called with labels.
    /// @param frees the number that stands for "free this voxel"; 0: none (LabelListed::frees)
    [[nodiscard]] LabelListed label(
        std::uint8_t plane, const std::bitset<256>& overwritable, std::uint8_t frees);

private:
    /// Along x, what is asked of each brick's voxels; empty: nothing.
    using RowOfBricks = std::vector<std::vector<std::uint8_t>>;

    /// Afterwards no row is left.
    template <class Brick> [[nodiscard]] std::vector<Brick> takeBricks();

    BrickGrid m_grid;
    std::map<int, RowOfBricks> m_rows; ///< by number, y first, then z; those that runs lie in
};

} // namespace core
