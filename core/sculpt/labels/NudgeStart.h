// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/CapsuleSweep.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

/// How a nudge begins: a disc in one slice that pushes the border of a segment, outwards if it
/// begins in the segment, inwards if it begins beside it. Pushing is a stroke of that disc
/// (PaintStroke::Tool): outwards what it sweeps becomes the segment's, inwards it is the segment's
/// no more. So where the disc begins wholly on one side of the border, the border goes exactly as
/// far as the disc is pushed against it, and nothing changes before it touches.
///
/// The rule is in integers, and the coordinates are those of CapsuleSweep.h:
///
/// 1. Voxels. Those of the slab (rule 2 there) whose d² = (p.x − centre.x)² + (p.y − centre.y)²,
///    exact in 64 bits, is at most (radius + margin)², where margin = 2 << shift.
/// 2. Side. It begins inside if one of these voxels is the segment's and none of the others has a
///    smaller d².
/// 3. Distance. Let D² be the smallest d² of the voxels on the other side: inside, of those that
///    are not the segment's; else, of those that are. The distance is ⌊√D²⌋ − margin; if there is
///    no such voxel, it is the radius. The margin covers what rules 3 and 4 there round off, so a
///    disc of this radius holds no voxel of the other side.
/// 4. Radius that fits. The lesser of the radius and the distance, the distance counting at least
///    max(⌊rampHalfWidth / 2⌋, 1024), which is a quarter of the finest spacing or 1/64 mm; rounded
///    down to a multiple of 64, since edits have radii in 1/1024 mm.
struct NudgeStart {
    bool isInside = false;
    std::int32_t fittingRadius = 0; ///< mm16
    bool operator==(const NudgeStart&) const = default;
};

/// @param frame of the disc with the radius that was chosen, flat and sound
/// @param centre where it begins, stroke coordinates; z does not count
/// @param near labels of the segment's plane, at least of the bricks that bricksNear() lists for a
/// point there, each once; bricks without bytes hold voxels of no segment
[[nodiscard]] NudgeStart nudgeStart(const CapsuleFrame& frame, const glm::ivec3& centre,
    const BrickGrid& grid, std::uint8_t label, const std::vector<BrickImage>& near);

} // namespace core
