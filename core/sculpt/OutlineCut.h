// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/CutFrame.h"
#include "core/sculpt/OutlineRaster.h"

namespace core {

/// Cuts out what lies under a closed curve along the view direction. It lies on the plane of
/// CutFrame.h and continues with rules 2 to 6 of that header.
///
/// 1. Elements with m = `mask`(a, b) > 0 are used; their columns have the weight
///    (m·255 + 128) >> 8.
/// 2. Through everything (`fromSurface` is off): no rays are cast; the column is (zStart − 2r,
///    zStart + sampleCount·zPerSample + 2r), for carving and restoring alike.
/// 3. From the surface: the column is that of a drill pressed to maxDepth (DrillCut.h, rule 1e),
///    (zSurface − front, min(zSurface + maxDepth, zExit)), or, when restoring, that of CutFrame.h,
///    rule 7. With the frame's throughGaps off, only the first layer of material is cut.
struct OutlineCut {
    std::uint8_t layer = 0;
    CutFrame frame;
    OutlineRaster mask{}; ///< its origin is the corner of element (0, 0)
    bool fromSurface = false;
    Laying laying = Laying::Carve;
};

/// @param hit of rule 3; not used where no ray is cast
/// @param weight m of rule 1
[[nodiscard]] CutColumn scissorsColumn(
    const OutlineCut& scissors, const SurfaceHit& hit, std::int32_t weight);

[[nodiscard]] Result<void> checkSound(const OutlineCut& scissors, const BrickGrid& grid);

} // namespace core
