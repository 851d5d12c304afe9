// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/SegmentShape.h"

namespace core {

struct GridGaussian;

/// What a Gaussian makes of a whole segment: of the blurred segment (GaussianFilter.h) all voxels
/// with more than one half become its own, those with less go, and those with just one half stay on
/// their side. The segment goes on beyond the image's border as it ends there.
///
/// Only voxels of the box around the segment are looked at, since none beside it can have more than
/// one half: all of the segment lies on one side of it along an axis, and there the weights are
/// less than one half, which no average across that axis makes more.
/// @param labels of the whole volume in the segment's plane, x fastest
/// Any thread that is no parallelFor's. Errors: OutOfMemory if gaussianBytes() of that box are more
/// than checkBytes() allows, Cancelled.
[[nodiscard]] Result<ShapeChange> gaussianChange(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, const GridGaussian& gaussian,
    const Progress& progress);

} // namespace core
