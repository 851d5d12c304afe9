// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/DrillCut.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

/// What a brush sweeps over, in integers: all voxels within a radius of a path, which is a chain of
/// straight pieces and never a row of stamps. Both engines follow the rules below to the bit.
///
/// Spaces. *Stroke* coordinates are mm from about the middle of the volume, in 16.16 fixed point
/// ("mm16") unless 2⁻³⁰ is said. A ball's axes are those of the patient; a disc lies in the plane
/// z = 0 and its z runs along the normal. *Units* are mm16 >> shift. `>>` is the arithmetic shift
/// (rounds down); round14(v) is (v + 2¹³) >> 14 and brings 2⁻³⁰ to 2⁻¹⁶.
///
/// 1. Voxels. For a brick with first voxel o: base = round14(origin + o.x·perI + o.y·perJ +
///    o.z·perK), and for the voxel at local (i, j, k): p = base + i·round14(perI) + j·round14(perJ)
///    + k·round14(perK).
/// 2. Slab. Of a disc, only voxels with |p.z| ≤ halfThickness; from here on p.z counts as 0.
/// 3. Distance to one capsule. a = p − from (of a disc a.z = 0). No distance if |a| > reach in any
///    component. q = a >> shift, L = length >> shift, u = direction, and
///    h = clamp((q·u + 2¹³) >> 14, 0, L), e = q − ((h·u + 2¹³) >> 14) per component, D² = e·e.
/// 4. Inside iff D² ≤ (radius >> shift)² for any capsule.
/// 5. Cut: the greatest over all capsules that have a distance of ramp(radius − (⌊√D²⌋ << shift)),
///    ramp(t) = ((clamp(t, −r, r) + r)·255) / (2r) with r = rampHalfWidth; 0 where there is none.
///
/// All of it is "or" and "max" over capsules: neither their order nor repetition matters.
struct CapsuleFrame {
    Fixed3 origin{}; ///< stroke coordinates of voxel (0, 0, 0), mm · 2³⁰
    Fixed3 perI{}; ///< change per voxel along i, mm · 2³⁰
    Fixed3 perJ{};
    Fixed3 perK{};
    bool disc = false;
    std::int32_t halfThickness = 0; ///< mm16, of a disc: half the distance of neighbouring slices
    std::int32_t radius = 0; ///< mm16
    std::int32_t rampHalfWidth = 0; ///< mm16, half the finest spacing; ≥ 1
    std::int32_t reach = 0; ///< mm16, ≥ radius + rampHalfWidth + the longest capsule
    std::int32_t shift = 0; ///< so that reach >> shift < 2¹⁴
};

/// A piece of the path: all that lies within the radius of a straight line.
struct Capsule {
    glm::ivec3 from{0}; ///< mm16
    glm::ivec3 direction{0}; ///< unit vector · 2¹⁴; 0: a point
    std::int32_t length = 0; ///< mm16
};

/// Whether every number of a frame is one that the rules allow.
[[nodiscard]] bool isSound(const CapsuleFrame& frame);

/// Rule 1: stroke coordinates of a brick's first voxel.
[[nodiscard]] glm::ivec3 strokeBase(const CapsuleFrame& frame, const glm::ivec3& firstVoxel);
/// Rule 1: steps from voxel to voxel inside a brick, as matrix columns.
[[nodiscard]] glm::ivec3 strokeStep(const Fixed3& perVoxel);

/// Bricks that a capsule may meet, ascending; rather too many than too few.
[[nodiscard]] std::vector<std::uint32_t> bricksNear(
    const CapsuleFrame& frame, const Capsule& capsule, const BrickGrid& grid);

} // namespace core
