// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/MaskFrame.h"
#include "core/sculpt/MaskRaster.h"

#include <vector>

namespace core {

/// Takes a shell of even thickness off a surface region (seed A §4.4), on the plane of MaskFrame.h,
/// whose rules 2 to 6 it goes on with. The paper sends each point along its own normal, which piles
/// up under convex surfaces and leaves gaps under concave ones; here the surface is moved inward as
/// a whole: what lies within `depth` of it is cut.
///
/// 1. Elements with m = `mask`(a, b) > 0 are cast.
/// 2. Sheet. Two elements that met a surface and share a side belong together where their zSurface
///    differ by no more than `jump`. The largest connected part is the sheet (of equals the one
///    with the first element, b before a): what is seen through a gap or past an edge is left
///    alone. Where jump < 0 all that met a surface are the sheet.
/// 3. Depth field. With R = depth, h(p, q) = ⌊√(R² − (p² + q²)·pitch²)⌋ where that is no root of a
///    negative number: E(a, b) = max over (p, q), (a + p, b + q) in the sheet, of
///    zSurface(a + p, b + q) + h(p, q). Restoring: min of zSurface(a + p, b + q) − h(p, q).
/// 4. Columns of the elements of the sheet, where R > 0: weight (m·255 + 128) >> 8,
///    (zSurface − front, min(E, zExit, zSurface + maxDepth)), or restoring as rule 7 of MaskFrame.h
///    says with max(E, zSurface − maxDepth) for zSurface − D.
/// 5. Whatever depths it was told one after the other, coverage is what it was before the peel with
///    the columns of the last depth laid into it.
struct MaskPeel {
    std::uint8_t layer = 0;
    MaskFrame frame;
    MaskRaster mask{}; ///< its origin is the corner of element (0, 0)
    std::int32_t jump = -1; ///< mm16
    Laying laying = Laying::Carve;
};

/// The elements of a mask that take part, and their surface; rows along a, as MaskRaster::values.
struct PeelSheet {
    glm::ivec2 first{0};
    glm::ivec2 size{0};
    std::vector<std::int32_t> surface{}; ///< mm16; SurfaceHit::none: takes no part
};

/// Rule 2. @param hits one for each value of the mask
[[nodiscard]] PeelSheet peelSheet(const MaskPeel& peel, const std::vector<SurfaceHit>& hits);

/// Rule 3 for every element of the sheet; what takes no part stays SurfaceHit::none. Farther off
/// parts of the sheet are looked at only where they can matter: on smooth surfaces the cost is
/// about that of the sheet times a few dozen, at the roughest that times the elements of a disc of
/// R.
[[nodiscard]] std::vector<std::int32_t> offsetSurface(
    const PeelSheet& sheet, std::int32_t pitch, std::int32_t depth, bool restore);

/// Rule 4. @param end of rule 3; @param weight m
[[nodiscard]] MaskColumn peelColumn(
    const MaskFrame& frame, const SurfaceHit& hit, std::int32_t end, std::int32_t weight);

[[nodiscard]] Result<void> checkSound(const MaskPeel& peel, const BrickGrid& grid);

} // namespace core
