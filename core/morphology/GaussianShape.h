// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/SegmentShape.h"

#include <vector>

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

/// What several segments gain, and what of them becomes free.
struct JointChange {
    std::vector<VoxelRuns> given; ///< of each of them; voxels that were free, or another's of them
    VoxelRuns freed;
};

/// Several segments smoothed together: each is blurred, and so is all that no segment has. A voxel
/// that one of them has, or none, becomes the one's with the greatest value; of several that of the
/// lowest label, where no segment is 0; and where all have 0 it stays as it is. So no gap opens
/// between neighbours. Voxels of other segments stay theirs and count for nobody, so that none
/// opens beside them either.
///
/// Cost: a blurring of the box around each segment, and one of the box around all.
/// @param segments labels, ascending
/// Any thread that is no parallelFor's. Errors: OutOfMemory, Cancelled.
[[nodiscard]] Result<JointChange> jointGaussianChange(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::span<const std::uint8_t> segments, const GridGaussian& gaussian,
    const Progress& progress);

} // namespace core
