// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/CutFrame.h"
#include "core/sculpt/OutlineRaster.h"

namespace core {

/// How the pressure of the pen becomes depth.
enum class DrillMode : std::uint8_t {
    Limit, ///< as deep as the deepest press, however long the pen rests
    Rate, ///< deeper for as long as the pen presses, down to a floor
};

/// A drill stroke in integers: everything that decides which voxels it cuts (seed A §4.1, 4.2). It
/// lies on the plane of CutFrame.h and continues with rules 2 to 6 of that header.
///
/// 1. a. Mask. Under a sample s, element (a, b) has the weight m, 0 … 256. For round masks (`mask`
///       is empty) m = clamp(⌊((maskRadius − d)·256 + 128·pitch) / pitch⌋, 0, 256), where
///       d = ⌊√(dx² + dy²)⌋ and dx, dy lead from the sample to c; this is computed in 64 bits. For
///       all others m is the value of `mask` at (a − ⌊x_s / pitch⌋, b − ⌊y_s / pitch⌋).
///    b. Contribution. A sample with depth_s > 0 contributes to the elements under it, which are
///       those with m > 0: (depth_s · m) >> 8 in mode Limit, depth_s · m in mode Rate.
///    c. Guard. Z_s is the lower median of zSurface over the elements under s that have one. If
///       guard ≥ 0, an element with zSurface > Z_s + guard receives nothing from s: the surface has
///       a hole there, and the drill does not fall through it. This does not depend on the order of
///       the samples.
///    d. Depth D(a, b) of an element: in mode Limit the greatest contribution that it receives, in
///       mode Rate min(maxDepth, (sum of contributions) >> 16), in 64 bits.
///    e. Column. An element with D > 0 and a surface has a column of weight 255:
///       (zSurface − front, min(zSurface + D, zExit)), or, when restoring, that of CutFrame.h, rule
///       7.
struct DrillCut {
    std::uint8_t layer = 0;
    CutFrame frame;
    std::int32_t maskRadius = 0; ///< mm16, for round masks
    OutlineRaster mask{}; ///< its origin is the middle of element (0, 0); empty: round
    DrillMode mode = DrillMode::Limit;
    std::int32_t guard = -1; ///< mm16; negative: no guard
    Laying laying = Laying::Carve;
};

/// One point of the resampled path: where the mask was and how deep it was pressed.
struct DrillSample {
    std::int32_t x = 0; ///< mm16
    std::int32_t y = 0; ///< mm16
    std::int32_t depth = 0; ///< Limit: mm16, 0 … maxDepth; Rate: the depth it adds, mm in 2⁻²⁴, ≥ 0
    bool operator==(const DrillSample&) const = default;
};

/// Rule 1a.
[[nodiscard]] std::int32_t maskWeight(
    const DrillCut& cut, const DrillSample& sample, const glm::ivec2& element);

/// Rule 1b.
[[nodiscard]] std::int64_t contribution(
    const DrillCut& cut, const DrillSample& sample, std::int32_t weight);

/// Rule 1e.
[[nodiscard]] CutColumn drillColumn(
    const CutFrame& frame, const SurfaceHit& hit, std::int32_t depth);

/// The elements that a sample may change.
[[nodiscard]] ElementBox elementsUnder(const DrillCut& cut, const DrillSample& sample);

[[nodiscard]] Result<void> checkSound(const DrillCut& cut, const BrickGrid& grid);

} // namespace core
