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

/// What limits a flood besides codes and box. Values "by cell" are those of the voxels that
/// represent the cells.
struct CoarseWalls {
    std::span<const std::uint8_t> labels{}; ///< by cell; empty: all 0
    std::span<const std::uint8_t> coverage{}; ///< by cell, 128 or more: closed; empty: all 0
    const CoarseBarriers* barriers = nullptr; ///< of the same grid; null: none
};

/// A seed with the code of its voxel.
struct CoarseSeed {
    /// The segment to which the seed belongs: the growth itself, or a rival with a lower or a
    /// higher label. Of segments that reach a cell at the same time the first in this order takes
    /// it, as the lower label does in a growth.
    enum class Of : std::uint8_t { RivalBefore, Own, RivalAfter };
    glm::ivec3 voxel{0};
    int code = 0;
    Of of = Of::Own;
    bool operator==(const CoarseSeed&) const = default;
};

/// Estimates quickly what a growth from seeds to closure would take: it works on cells (CoarseGrid)
/// instead of voxels, and treats each cell as if all of it were like its middle voxel. If the grid
/// is exact, the result is what a GrowBurst would take by the interval, box, connectivity and
/// labels of the rule, the means around its seeds, and by coverage (GrowLimits::onlyVisible) and
/// barriers. Otherwise structures thinner than a cell may be missed, and gaps narrower than a cell
/// passed.
///
/// A cell is open if its middle voxel lies in the box and is not carved, the code there is in the
/// interval (and in `among`), and its label is not closed. Seeds count only if their own voxel is
/// in interval and box, and their cell is neither carved nor has a closed label. The flood starts
/// from the cell of each seed or, if that cell is not open, from the open ones of the 26 cells
/// around it; the cell itself is reached in both cases.
///
/// Barriers may be one voxel thin, and nothing passes them: an open cell with barriers is flooded
/// voxel by voxel, and only the voxels reached in it are counted.
///
/// Rivals are the segments that grow in the same burst. A cell that a rival reaches earlier,
/// counted in voxels along the path, is not taken. Rivals are not distinguished from one another.
///
/// With a passage width the flood goes only through cells around which a ball has room, and
/// everything that such balls cover is reached; cells with barriers then count as closed.
///
/// Errors: Cancelled. Cost ∝ the cells, and the voxels of those with barriers; two million cells
/// take some tens of milliseconds.
[[nodiscard]] Result<CoarseReach> coarseFlood(const CoarseCodes& codes, const CoarseWalls& walls,
    const std::vector<CoarseSeed>& seeds, const CoarseRule& rule,
    const Progress& progress = Progress());

} // namespace core
