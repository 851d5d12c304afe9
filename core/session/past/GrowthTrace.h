// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/edits/kinds/Edit.h"
#include "core/history/History.h"

#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace core {

/// A brick whose seed words differ, and the bounding box of the voxels concerned.
struct ChangedWords {
    BrickKey key;
    VoxelBox box; ///< in voxels
};
/// Finds them among XOR images. Cost ∝ their seed words; any thread.
[[nodiscard]] std::vector<ChangedWords> changedWords(
    const std::vector<BrickImage>& differences, const BrickGrid& grid);

/// Where growths may have read labels: wherever there were or came seed words, and within one voxel
/// around them (RowTrace::grownBeside). It is built row by row from what each row changed.
class GrowthTrace {
public:
    /// Whether a row continued a growth from all present members and read no voxels but them and
    /// their neighbours. (With a passage width it reads voxels all around.)
    [[nodiscard]] static bool isOf(const Edit& edit);
    /// Whether the differences of a row must be noted because they may contain seed words.
    [[nodiscard]] static bool mayNeed(const Edit& edit);

    void note(RowId row, const std::vector<ChangedWords>& words, const BrickGrid& grid);
    /// The bricks in which rows up to this one changed seed words of a plane, and the bricks next
    /// to such voxels.
    [[nodiscard]] std::set<std::uint32_t> bricksUpTo(RowId row, std::uint8_t plane) const;

private:
    using ByPlane = std::map<std::uint8_t, std::set<std::uint32_t>>;
    std::map<RowId, ByPlane> m_besideWords;
};

} // namespace core
