// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/CutFrame.h"
#include "core/sculpt/labels/LayerWrites.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

/// Give a label to what lies inside a closed outline in one slice, or remove it from there. Both
/// engines follow these rules to the bit.
///
/// 1. A voxel lies at p = round14(origin + x·perI + y·perJ + z·perK): p.x and p.y in the plane of
///    the slice, p.z across it, in mm16. The sum is exact (64 bits), whatever brick the voxel is
///    in.
/// 2. Voxels with |p.z| ≤ halfThickness and lowCode ≤ code ≤ highCode are chosen if (p.x, p.y) lies
///    on the outline, or inside: at a place around which the outline winds, in whichever direction
///    (non-zero winding). So a curve that overlaps itself leaves no hole, and neither its direction
///    nor its first corner matters.
/// 3. The outline runs straight from corner to corner, and from the last one to the first.
/// 4. Chosen voxels follow the rule of LabelTarget, or with `erase` that of the voxels which
///    RelabelListed takes.
struct LabelOutlined {
    /// Corners lie within ± this on each axis, mm16, so that no product overflows.
    static constexpr std::int32_t reach = 1 << 29;
    static constexpr std::size_t mostCorners = 10000;

    LabelTarget target{};
    bool erase = false;
    int lowCode = 0;
    int highCode = 65535;
    Fixed3 origin{}; ///< plane coordinates of voxel (0, 0, 0), mm · 2³⁰
    Fixed3 perI{}; ///< change per voxel along i, mm · 2³⁰
    Fixed3 perJ{};
    Fixed3 perK{};
    std::int32_t halfThickness = 0; ///< mm16
    std::vector<glm::ivec2> corners{}; ///< mm16, at least three
    std::optional<EditableVoxels> editable{}; ///< none: any
};

[[nodiscard]] Result<void> checkSound(const LabelOutlined& edit, const BrickGrid& grid);

// The cost of both functions follows what the outline covers, not the volume. Any thread; the edit
// is sound.

/// Bricks in which a voxel may be chosen, ascending. The list may contain too many, never too few.
[[nodiscard]] std::vector<std::uint32_t> bricksNear(
    const LabelOutlined& edit, const BrickGrid& grid);

/// The voxels that are chosen if their codes allow it. Bricks without any are left out.
[[nodiscard]] std::vector<RelabelListed::Brick> voxelsWithin(
    const LabelOutlined& edit, const BrickGrid& grid);

} // namespace core
