// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/SegmentShape.h"
#include "core/morphology/SidedBall.h"

#include <cstdint>

namespace core {

/// Grows or shrinks a segment by margins that differ from side to side. Growing, it gains the free
/// voxels that the body around one of its voxels reaches. Shrinking, it loses its voxels around
/// which the body reaches a voxel outside the segment. The border of the image is no border of the
/// segment, as with ShapeOperation::Shrink.
///
/// Exact: no floating-point number decides. The cost does not depend on the margins; the method is
/// that of MaskDilation.h, with half parabolas.
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// Any thread outside a parallelFor(). Errors: OutOfMemory, Cancelled.
[[nodiscard]] Result<ShapeChange> sidedMarginChange(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, bool grows, const SidedBall& ball,
    const Progress& progress);

} // namespace core
