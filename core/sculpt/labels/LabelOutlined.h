// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/CutFrame.h"
#include "core/sculpt/labels/LayerWrites.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

/// Give a label to the voxels inside a closed outline in one slice, or remove it from them. Both
/// engines follow these rules to the bit.
///
/// 1. A voxel lies at p = round14(origin + x·perI + y·perJ + z·perK), in mm16: p.x and p.y in the
///    plane of the slice, p.z across it. The sum is exact (64 bits) and does not depend on the
///    brick that contains the voxel.
/// 2. Voxels with |p.z| ≤ halfThickness and lowCode ≤ code ≤ highCode are chosen if (p.x, p.y) lies
///    on the outline or inside it. Inside is every place around which the outline winds, in either
///    direction (non-zero winding). So a curve that overlaps itself leaves no hole, and neither its
///    direction nor its first corner matters.
/// 3. The outline runs straight from corner to corner, and from the last one to the first.
/// 4. Chosen voxels follow the rule of LabelTarget, or with `erase` the rule for voxels that
///    RelabelListed takes.
struct LabelOutlined {
    /// Corners lie within ± this on each axis, mm16, so that no product overflows.
    static constexpr std::int32_t reach = 1 << 29;
    static constexpr std::size_t mostCorners = 10000;

    LabelTarget target{};
    bool erase = false;
    int lowCode = 0;
    int highCode = 65535;
    Fixed3 origin{}; ///< position of voxel (0, 0, 0) in plane coordinates, mm · 2³⁰
    Fixed3 perI{}; ///< change per voxel along i, mm · 2³⁰
    Fixed3 perJ{};
    Fixed3 perK{};
    std::int32_t halfThickness = 0; ///< mm16
    std::vector<glm::ivec2> corners{}; ///< mm16, at least three
    std::optional<EditableVoxels> editable{}; ///< none: any
};

[[nodiscard]] Result<void> checkSound(const LabelOutlined& edit, const BrickGrid& grid);

// The cost of both functions is ∝ what the outline covers, not ∝ the volume. Any thread. The edit
// must be sound (checkSound()).

/// Numbers of the bricks in which a voxel may be chosen, ascending. The list may contain too many,
/// but never too few.
[[nodiscard]] std::vector<std::uint32_t> bricksNear(
    const LabelOutlined& edit, const BrickGrid& grid);

/// The voxels that are chosen if their codes allow it (rule 2). Bricks without any are left out.
[[nodiscard]] std::vector<RelabelListed::Brick> voxelsWithin(
    const LabelOutlined& edit, const BrickGrid& grid);

} // namespace core
