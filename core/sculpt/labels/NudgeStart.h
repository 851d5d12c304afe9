// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/CapsuleSweep.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

/// How a nudge begins. A nudge pushes the border of a segment with a disc in one slice: outwards if
/// it begins inside the segment, inwards if it begins outside. It is a stroke of that disc
/// (PaintStroke::Tool): outwards the segment receives what the disc sweeps, inwards it loses it. So
/// if the disc begins wholly on one side of the border, the border moves exactly as far as the disc
/// is pushed against it, and nothing changes before the disc touches it.
///
/// The rule is in integers, with the coordinates of CapsuleSweep.h:
///
/// 1. Voxels. Those in the slab (rule 2 there) count whose d² = (p.x − centre.x)² + (p.y −
///    centre.y)², exact in 64 bits, is at most (radius + margin)², where margin = 2 << shift.
/// 2. Side. It begins inside if the segment has one of these voxels and none of the others has a
///    smaller d².
/// 3. Distance. Let D² be the smallest d² of the voxels on the other side, which are those outside
///    the segment if it begins inside, and those of the segment otherwise. The distance is ⌊√D²⌋ −
///    margin, or the radius if there is no such voxel. The margin covers what rules 3 and 4 there
///    round off, so a disc with this radius contains no voxel of the other side.
/// 4. Fitting radius. The lesser of the radius and the distance, where the distance counts as at
///    least max(⌊rampHalfWidth / 2⌋, 1024), that is a quarter of the finest spacing or 1/64 mm. It
///    is rounded down to a multiple of 64, because radii of edits are multiples of 1/1024 mm.
struct NudgeStart {
    bool isInside = false;
    std::int32_t fittingRadius = 0; ///< the radius of rule 4, mm16
    bool operator==(const NudgeStart&) const = default;
};

/// Finds out how a nudge begins.
/// @param frame that of the disc with the radius that the user chose; flat and sound
/// @param centre where the disc begins, in stroke coordinates; z does not count
/// @param near labels of the segment's plane, at least of the bricks that bricksNear() lists for
/// this place, each brick once; bricks without bytes contain no segment
[[nodiscard]] NudgeStart nudgeStart(const CapsuleFrame& frame, const glm::ivec3& centre,
    const BrickGrid& grid, std::uint8_t label, const std::vector<BrickImage>& near);

} // namespace core
