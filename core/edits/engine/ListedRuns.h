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

/// Makes of runs of voxels what an engine is asked to relabel, brick by brick.
class ListedRuns {
public:
    explicit ListedRuns(const glm::ivec3& volumeSize);

    /// @param asked RelabelListed::give or take, or of LabelListed a label or its `frees`
    void add(const VoxelRuns& runs, std::uint8_t asked);
    /// With all that was added; it is empty afterwards.
    [[nodiscard]] RelabelListed relabel(LabelTarget target);
    /// The same where labels were asked for, or what frees a voxel.
    [[nodiscard]] LabelListed label(
        std::uint8_t plane, const std::bitset<256>& overwritable, std::uint8_t frees);

private:
    BrickGrid m_grid;
    std::map<std::uint32_t, std::vector<std::uint8_t>> m_bricks;
};

} // namespace core
