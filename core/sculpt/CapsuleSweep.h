// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/DrillCut.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

/// The volume that a brush sweeps, in integers: all voxels within a radius of a path, or in the
/// squares or cubes of this half side around its points. The path is a chain of straight pieces
/// (capsules), not a row of stamps. Both engines follow these rules exactly.
///
/// Spaces: *stroke* coordinates are mm from about the middle of the volume, in 16.16 fixed point
/// ("mm16") unless 2⁻³⁰ is stated. The axes for a ball are those of the patient, for a cube those
/// of its sides; a flat brush (disc or square) lies in the plane z = 0, its z runs along the
/// normal, and a square's sides run along x and y. *Units* are mm16 >> shift. `>>` is the
/// arithmetic shift (rounds down); round14(v) is (v + 2¹³) >> 14 and converts 2⁻³⁰ to 2⁻¹⁶.
///
/// 1. Voxels. For a brick with first voxel o: base = round14(origin + o.x·perI + o.y·perJ +
///    o.z·perK). For the voxel at local (i, j, k): p = base + i·round14(perI) + j·round14(perJ)
///    + k·round14(perK).
/// 2. Slab. For a flat brush, only voxels with |p.z| ≤ halfThickness take part, and then p.z counts
/// as 0.
/// 3. Distance to one capsule. Let a = p − from (for a flat brush a.z = 0). If |a| > reach in any
///    component, there is no distance. Otherwise q = a >> shift, L = length >> shift,
///    u = direction, h = clamp((q·u + 2¹³) >> 14, 0, L), e = q − ((h·u + 2¹³) >> 14) per component,
///    and D² = e·e.
///    For a square or cube, D is the least whole half side with which a square or cube around some
///    point between from and its other end holds the voxel, that is, the greatest of: for each
///    component c, ⌈max(2¹⁴·q.c − max(L·u.c, 0), min(L·u.c, 0) − 2¹⁴·q.c, 0) / 2¹⁴⌉; for each two
///    of them c and d with m = |u.c| + |u.d| > 0, ⌈|q.c·u.d − q.d·u.c| / m⌉.
/// 4. The radius of a capsule is R = max(radius − less, 0). A voxel is inside if D² ≤ (R >> shift)²
///    for any capsule.
/// 5. The cut of a voxel is the greatest value over all capsules that have a distance of
///    ramp(R − (⌊√D²⌋ << shift)), where ramp(t) = ((clamp(t, −r, r) + r)·255) / (2r)
///    and r = rampHalfWidth; it is 0 if no capsule has a distance.
///
/// Capsules are combined by "or" and "max" only, so neither their order nor repetition matters.
struct CapsuleFrame {
    Fixed3 origin{}; ///< stroke coordinates of voxel (0, 0, 0), mm · 2³⁰
    Fixed3 perI{}; ///< change per voxel along i, mm · 2³⁰
    Fixed3 perJ{};
    Fixed3 perK{};
    bool isFlat = false; ///< disc or square
    bool isSquare = false; ///< square or cube
    std::int32_t halfThickness = 0; ///< mm16; if flat: half the distance of neighbouring slices
    std::int32_t radius = 0; ///< mm16; of a square or cube: half a side
    std::int32_t rampHalfWidth = 0; ///< mm16, half the finest spacing; ≥ 1
    std::int32_t reach = 0; ///< mm16, ≥ radius + rampHalfWidth + the longest capsule
    std::int32_t shift = 0; ///< so that reach >> shift < 2¹⁴
};

/// A piece of the path: the voxels within the radius of a straight line belong to it; of a square
/// or cube, those that it covers on its way along the line.
struct Capsule {
    glm::ivec3 from{0}; ///< mm16
    glm::ivec3 direction{0}; ///< unit vector · 2¹⁴; 0: a point
    std::int32_t length = 0; ///< mm16
    /// By how much its radius is smaller than the frame's, because the pen was not pressed fully;
    /// mm16, 0 … the frame's radius. A radius that changes along the path is made of many short
    /// capsules.
    std::int32_t less = 0;
    /// The share of the tolerance that counts here for a brush that follows edges (EdgeRegion.h),
    /// if the pressure changes that instead of the radius; 0 … 255.
    std::int32_t strength = 255;
};

/// Whether every number of the frame is in the range that the rules allow.
[[nodiscard]] bool isSound(const CapsuleFrame& frame);

/// Rule 1: stroke coordinates of a brick's first voxel.
[[nodiscard]] glm::ivec3 strokeBase(const CapsuleFrame& frame, const glm::ivec3& firstVoxel);
/// Rule 1: steps from voxel to voxel inside a brick, as matrix columns.
[[nodiscard]] glm::ivec3 strokeStep(const Fixed3& perVoxel);

/// Whether a voxel lies in the slab of a flat brush (rule 2). Of a ball or cube: always.
[[nodiscard]] bool isInSlab(const CapsuleFrame& frame, const glm::ivec3& voxel);
/// The index axis along which a flat brush is one voxel thick: the one with the greatest of
/// |perI.z|, |perJ.z| and |perK.z| (strokeStep()), the first if several are equal.
[[nodiscard]] int steepestAxis(const CapsuleFrame& frame);

/// Bricks that a capsule may meet, ascending. The list may contain too many, never too few.
[[nodiscard]] std::vector<std::uint32_t> bricksNear(
    const CapsuleFrame& frame, const Capsule& capsule, const BrickGrid& grid);

} // namespace core
