// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/CutFrame.h"
#include "core/sculpt/OutlineRaster.h"
#include "core/sculpt/labels/LayerWrites.h"

#include <bitset>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace core {

/// Give a label to the voxels under a closed curve along the view direction, or remove labels from
/// them. The curve lies on the plane of CutFrame.h, as for the scissors that carve (OutlineCut.h).
/// Both engines follow these rules to the bit.
///
/// 1. An element of the plane is under the curve if `mask` is ≥ 128 there. There the scissors that
///    carve leave a coverage of at least 128.
/// 2. Voxels and their elements are those of CutFrame.h, rule 6. A voxel is concerned if nothing
///    hides it and lowCode ≤ code ≤ highCode.
/// 3. Without `fromSurface`, through the whole volume: the concerned voxels are chosen whose
///    element is under the curve, or with `outside` those whose element is not.
/// 4. With `fromSurface`, each element under the curve has a ray, that of CutFrame.h, rule 2; the
///    start of the ray decides in the same way whether it meets anything, and the same samples are
///    used. Sample n belongs to the voxel (P(n, 0) + 2¹⁵) >> 16; samples outside the volume do not
///    count. zSurface = z(n, 0) of the first sample whose voxel has lowCode ≤ code ≤ highCode and,
///    if labels are removed, held one of them when the edit began. The element reaches to zSurface
///    + maxDepth; if there is no such sample, nothing is chosen under it. The concerned voxels are
///    chosen whose element is under the curve and reaches to their z or farther.
/// 5. Without `erased`, chosen voxels follow the rule of LabelTarget. With `erased`, a chosen voxel
///    becomes 0 if the plane holds one of these labels there, and a seed word there that has one of
///    them, of a member or a pending seed, becomes unvisited; `target` then states only the plane.
///
/// After it has begun, an engine may carry it out brick by brick; it is complete at the latest when
/// it is committed.
struct LabelScissors {
    static constexpr int covered = 128; ///< rule 1
    static constexpr std::int32_t nowhere =
        std::numeric_limits<std::int32_t>::min(); ///< reach of an element that chooses nothing

    LabelTarget target{};
    std::bitset<256> erased{};
    bool outside = false; ///< must be false with fromSurface
    bool fromSurface = false; ///< down to the depth frame.maxDepth
    int lowCode = 0; ///< greater than highCode: no voxel is concerned
    int highCode = 65535;
    CutFrame frame{};
    OutlineRaster mask{}; ///< its origin is the corner of element (0, 0)
    std::optional<EditableVoxels> editable{}; ///< limits what rule 5 changes; none: any voxel

    [[nodiscard]] bool erases() const { return erased.any(); }
};

[[nodiscard]] Result<void> checkSound(const LabelScissors& edit, const BrickGrid& grid);

/// Numbers of the bricks in which a voxel may be chosen, ascending. The list may contain too many,
/// but never too few. Any thread.
/// @pre the edit is sound (checkSound())
[[nodiscard]] std::vector<std::uint32_t> bricksNear(
    const LabelScissors& edit, const BrickGrid& grid);

/// How far each element of the mask reaches (rules 1 and 4), mm16, in the order of the mask.
/// Outside the curve it is `nowhere`; without fromSurface it is farther than any voxel inside the
/// curve.
/// @param surfaces zSurface of each element, or SurfaceHit::none; empty without fromSurface
[[nodiscard]] std::vector<std::int32_t> scissorsReach(
    const LabelScissors& edit, std::span<const std::int32_t> surfaces);

} // namespace core
