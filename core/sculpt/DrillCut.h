// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/MaskFrame.h"
#include "core/sculpt/MaskRaster.h"

namespace core {

enum class DrillMode : std::uint8_t {
    Limit, ///< no deeper than the deepest press, however long the pen rests
    Rate, ///< deeper as long as it is pressed, down to a floor
};

/// A drill stroke in integers: everything that decides a voxel (seed A §4.1, 4.2; DESIGN §5), on
/// the plane of MaskFrame.h, whose rules 2 to 6 it goes on with.
///
/// 1. a. Mask. Under a sample s element (a, b) has the weight m, 0 … 256. Round masks (`mask` is
///       empty): m = clamp(⌊((maskRadius − d)·256 + 128·pitch) / pitch⌋, 0, 256),
///       d = ⌊√(dx² + dy²)⌋, dx, dy from the sample to c. 64-bit. All others: m is the value of
///       `mask` at (a − ⌊x_s / pitch⌋, b − ⌊y_s / pitch⌋).
///    b. Contribution of a sample with depth_s > 0 to the elements under it, those with m > 0: in
///       mode Limit (depth_s · m) >> 8, in mode Rate depth_s · m.
///    c. Guard. Z_s = the lower median of zSurface over the elements under s that have one. Where
///       guard ≥ 0, an element whose zSurface > Z_s + guard receives nothing from s: the surface
///       has a hole there, and the drill does not fall through. So it does not matter in which
///       order samples come.
///    d. Depth D(a, b), of what an element receives: in mode Limit the greatest, in mode
///       Rate min(maxDepth, (their sum) >> 16), 64-bit.
///    e. Column of an element with D > 0 and a surface, weight 255: (zSurface − front,
///       min(zSurface + D, zExit)), or restoring as rule 7 of MaskFrame.h says.
struct DrillCut {
    std::uint8_t layer = 0;
    MaskFrame frame;
    std::int32_t maskRadius = 0; ///< mm16, of round masks
    MaskRaster mask{}; ///< its origin is the middle of element (0, 0); empty: round
    DrillMode mode = DrillMode::Limit;
    std::int32_t guard = -1; ///< mm16; negative: none
    Laying laying = Laying::Carve;
};

/// One point of the resampled path: where the mask stood and how deep it was pressed.
struct DrillSample {
    std::int32_t x = 0; ///< mm16
    std::int32_t y = 0; ///< mm16
    std::int32_t depth = 0; ///< Limit: mm16, 0 … maxDepth; Rate: what it adds, mm in 2⁻²⁴, ≥ 0
    bool operator==(const DrillSample&) const = default;
};

/// Rule 1a.
[[nodiscard]] std::int32_t maskWeight(
    const DrillCut& cut, const DrillSample& sample, const glm::ivec2& element);

/// Rule 1b.
[[nodiscard]] std::int64_t contribution(
    const DrillCut& cut, const DrillSample& sample, std::int32_t weight);

/// Rule 1e.
[[nodiscard]] MaskColumn drillColumn(
    const MaskFrame& frame, const SurfaceHit& hit, std::int32_t depth);

/// Elements that a sample can reach.
[[nodiscard]] ElementBox elementsUnder(const DrillCut& cut, const DrillSample& sample);

[[nodiscard]] Result<void> checkSound(const DrillCut& cut, const BrickGrid& grid);

} // namespace core
