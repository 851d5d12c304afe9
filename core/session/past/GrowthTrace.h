// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/history/History.h"

#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace core {

/// The voxels of a brick whose seed words differ.
struct ChangedWords {
    BrickKey key;
    VoxelBox box; ///< index space
};
/// Of XOR images. Cost ∝ the seed words among them; any thread.
[[nodiscard]] std::vector<ChangedWords> changedWords(
    const std::vector<BrickImage>& differences, const BrickGrid& grid);

/// Where growths can have asked for labels: wherever seed words stood or came, and one voxel around
/// them (RowTrace::grownBeside). Told row by row what each changed.
class GrowthTrace {
public:
    /// Whether a row grew on from all members that were there, and asked no voxel but them and
    /// their neighbours. (A ball that has to pass asks voxels all around.)
    [[nodiscard]] static bool isOf(const Edit& edit);
    /// Whether the differences of such a row have to be noted, since there may be seed words.
    [[nodiscard]] static bool mayNeed(const Edit& edit);

    void note(RowId row, const std::vector<ChangedWords>& words, const Document& document);
    /// Bricks in which rows up to this one changed seed words, and those beside such voxels.
    [[nodiscard]] std::set<std::uint32_t> bricksUpTo(RowId row) const;

private:
    std::map<RowId, std::set<std::uint32_t>> m_besideWords;
};

} // namespace core
