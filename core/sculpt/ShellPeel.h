// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/CutFrame.h"
#include "core/sculpt/OutlineRaster.h"

#include <vector>

namespace core {

/// Removes a shell of even thickness from a region of a surface (seed A §4.4). It lies on the plane
/// of CutFrame.h and continues with rules 2 to 6 of that header. The paper moves each point along
/// its own normal, which piles up under convex surfaces and leaves gaps under concave ones; here
/// the surface is moved inwards as a whole: everything within the depth of it is cut.
///
/// 1. A ray is cast for each element with m = `mask`(a, b) > 0.
/// 2. Sheet. Two elements that met a surface and share a side are connected if their zSurface
///    differ by at most `jump`. The largest connected part is the sheet (of equally large ones, the
///    one that contains the first element, b before a). So surfaces that are seen through a gap or
///    past an edge are left alone. If jump < 0, all elements that met a surface are the sheet.
/// 3. Depth field. With R = depth, h(p, q) = ⌊√(R² − (p² + q²)·pitch²)⌋ where the radicand is not
///    negative. E(a, b) is the maximum of zSurface(a + p, b + q) + h(p, q) over all (p, q) for
///    which (a + p, b + q) is in the sheet. Restoring: the minimum of
///    zSurface(a + p, b + q) − h(p, q).
/// 4. Columns of the elements of the sheet, if R > 0: weight (m·255 + 128) >> 8,
///    (zSurface − front, min(E, zExit, zSurface + maxDepth)); when restoring, those of
///    CutFrame.h, rule 7, with max(E, zSurface − maxDepth) in place of zSurface − D.
/// 5. The depth may be changed any number of times: coverage is always that before the peel, cut by
///    the columns of the last depth.
struct ShellPeel {
    std::uint8_t layer = 0;
    CutFrame frame;
    OutlineRaster mask{}; ///< its origin is the corner of element (0, 0)
    std::int32_t jump = -1; ///< mm16
    Laying laying = Laying::Carve;
};

/// The elements of a mask that take part, with their surface; rows along a, as
/// OutlineRaster::values.
struct PeelSheet {
    glm::ivec2 first{0};
    glm::ivec2 size{0};
    std::vector<std::int32_t> surface{}; ///< mm16; SurfaceHit::none: takes no part
};

/// Rule 2. @param hits one for each value of the mask
[[nodiscard]] PeelSheet peelSheet(const ShellPeel& peel, const std::vector<SurfaceHit>& hits);

/// Rule 3 for every element of the sheet; the others remain SurfaceHit::none. Distant parts of the
/// sheet are examined only where they can matter: on smooth surfaces the cost is about the number
/// of elements times a few dozen, on the roughest ones times the elements of a disc of radius R.
[[nodiscard]] std::vector<std::int32_t> offsetSurface(
    const PeelSheet& sheet, std::int32_t pitch, std::int32_t depth, bool restore);

/// Rule 4. @param end of rule 3; @param weight m
[[nodiscard]] CutColumn peelColumn(
    const CutFrame& frame, const SurfaceHit& hit, std::int32_t end, std::int32_t weight);

[[nodiscard]] Result<void> checkSound(const ShellPeel& peel, const BrickGrid& grid);

} // namespace core
