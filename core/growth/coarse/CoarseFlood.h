// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/growth/coarse/CoarseBarriers.h"
#include "core/growth/coarse/CoarseGrid.h"
#include "core/growth/coarse/CoarseReach.h"
#include "core/growth/coarse/CoarseRule.h"

#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// What bounds a flood beside codes and box. By cell are the voxels that represent them.
struct CoarseWalls {
    std::span<const std::uint8_t> labels{}; ///< by cell; empty: all 0
    std::span<const std::uint8_t> coverage{}; ///< by cell, 128 or more: closed; empty: all 0
    const CoarseBarriers* barriers = nullptr; ///< of the same grid; null: none
};

/// A seed with the code of its voxel.
struct CoarseSeed {
    /// Whose it is. Who comes first takes what several reach at the same time, as the lower label
    /// does in a growth.
    enum class Of : std::uint8_t { RivalBefore, Own, RivalAfter };
    glm::ivec3 voxel{0};
    int code = 0;
    Of of = Of::Own;
    bool operator==(const CoarseSeed&) const = default;
};

/// Finds out about what a growth from seeds to closure would take, in little time: instead of
/// voxels it goes through cells (CoarseGrid), each of which is taken for as its middle voxel. If
/// the grid is exact, this is what a GrowBurst would take by the interval, box, connectivity and
/// labels of the rule, the means around its seeds, and by coverage (GrowLimits::onlyVisible) and
/// barriers; else structures and necks thinner than a cell may be missed, or passed.
///
/// A cell is open if the code of its middle voxel is in the interval (and `among`), that voxel in
/// the box and not carved, and its label not closed. Only seeds count whose own voxel is in
/// interval and box, and whose cell is neither carved nor has a closed label. Each reaches its own
/// cell, and goes on from there, or, if that is not open, from the open ones of the 26 cells around
/// it.
///
/// Barriers may be one voxel thin, and nothing passes them: an open cell that holds some is gone
/// through voxel by voxel, and of such a cell as many voxels are counted as were reached.
///
/// Rivals, the segments that grow in the same burst, are at each place sooner or later than the
/// growth itself, by voxels on the way; what they reach first is not taken. They are told from each
/// other nowhere.
///
/// With a passage width only those cells are gone through around which a ball has room, and what
/// such balls cover is reached; cells with barriers then count as closed.
///
/// Errors: Cancelled. Cost ∝ the cells, and the voxels of those with barriers; two million cells
/// take some tens of milliseconds.
[[nodiscard]] Result<CoarseReach> coarseFlood(const CoarseCodes& codes, const CoarseWalls& walls,
    const std::vector<CoarseSeed>& seeds, const CoarseRule& rule,
    const Progress& progress = Progress());

} // namespace core
