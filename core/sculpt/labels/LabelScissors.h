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

/// Give a label to what lies under a closed curve along the view direction, or take labels away
/// there. It lies on the plane of CutFrame.h, as the scissors that carve do (OutlineCut.h). Both
/// engines follow these rules to the bit.
///
/// 1. An element is under the curve if `mask` is ≥ 128 there, which is where the scissors that
///    carve leave coverage ≥ 128.
/// 2. A voxel and its element are those of CutFrame.h, rule 6. It is concerned if nothing hides it
///    and lowCode ≤ code ≤ highCode.
/// 3. Through everything: chosen are the concerned voxels whose element is under the curve, or,
///    with `outside`, those whose element is not.
/// 4. With `fromSurface`, each element under the curve has a ray: that of CutFrame.h, rule 2, whose
///    start decides in the same way whether it meets anything, and of which the same samples are
///    used. Sample n is about the voxel (P(n, 0) + 2¹⁵) >> 16; those beside the volume count for
///    nothing. zSurface = z(n, 0) of the first sample whose voxel has lowCode ≤ code ≤ highCode
///    and, where labels are taken away, held one of them when the edit began. The element reaches
///    to zSurface + maxDepth; without such a sample nothing of it is chosen. Chosen are the
///    concerned voxels whose element is under the curve and reaches to their z or farther.
/// 5. Without `erased`, chosen voxels follow the rule of LabelTarget. With it, a chosen voxel
///    becomes 0 if the plane holds one of these labels there, and a seed word there that has one
///    of them, of a member or a pending seed, becomes unvisited. `target` then only names the
///    plane.
///
/// An engine may carry it out brick by brick after it has begun; it is whole when it is committed.
struct LabelScissors {
    static constexpr int covered = 128; ///< rule 1
    static constexpr std::int32_t nowhere =
        std::numeric_limits<std::int32_t>::min(); ///< what an element reaches without rule 4

    LabelTarget target{};
    std::bitset<256> erased{};
    bool outside = false; ///< not with fromSurface
    bool fromSurface = false; ///< to the depth of the frame's maxDepth
    int lowCode = 0; ///< above highCode: no voxel is concerned
    int highCode = 65535;
    CutFrame frame{};
    OutlineRaster mask{}; ///< its origin is the corner of element (0, 0)
    std::optional<EditableVoxels> editable{}; ///< what rule 5 may change; none: any voxel

    [[nodiscard]] bool erases() const { return erased.any(); }
};

[[nodiscard]] Result<void> checkSound(const LabelScissors& edit, const BrickGrid& grid);

/// Bricks in which a voxel may be chosen, ascending. The list may contain too many, never too few.
/// Any thread; the edit is sound.
[[nodiscard]] std::vector<std::uint32_t> bricksNear(
    const LabelScissors& edit, const BrickGrid& grid);

/// How far each element of the mask reaches, mm16, in the mask's order: rules 1 and 4. Where the
/// curve is not it is nowhere, and without fromSurface it is farther than any voxel elsewhere.
/// @param surfaces zSurface of each element, or SurfaceHit::none; empty without fromSurface
[[nodiscard]] std::vector<std::int32_t> scissorsReach(
    const LabelScissors& edit, std::span<const std::int32_t> surfaces);

} // namespace core
