// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/SegmentShape.h"
#include "core/morphology/SidedBall.h"

#include <cstdint>

namespace core {

/// Grows a segment by margins that differ from side to side, or shrinks it by them: it gains what
/// the body around its voxels reaches, or loses the voxels around which the body reaches others.
/// The image's border is no border of the segment, as with ShapeOperation::Shrink.
///
/// Exact: no float decides. The cost does not depend on the margins: sums are worked out along
/// rows, then by lower envelopes of half parabolas along columns, and each voxel reaches so many
/// slices.
/// @param labels of the whole volume in the segment's plane, x fastest
/// Any thread that is no parallelFor's. Errors: OutOfMemory, Cancelled.
[[nodiscard]] Result<ShapeChange> sidedMarginChange(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, bool grows, const SidedBall& ball,
    const Progress& progress);

} // namespace core
