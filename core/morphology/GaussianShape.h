// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/SegmentShape.h"

#include <vector>

namespace core {

struct GridGaussian;

/// Smooths a whole segment with a Gaussian. The segment is blurred (GaussianFilter.h); free voxels
/// with more than one half join it, voxels of the segment with less than one half leave it, and
/// with exactly one half nothing changes. Beyond the border of the image the segment is continued
/// as it is at the border.
///
/// Only voxels in the box around the segment are examined, because no voxel outside it can get more
/// than one half: along some axis the whole segment lies on one side of such a voxel, where the
/// weights add up to less than one half, and averaging across that axis cannot increase this.
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// Any thread outside a parallelFor(). Errors: OutOfMemory if gaussianBytes() of that box are more
/// than checkBytes() allows, Cancelled.
[[nodiscard]] Result<ShapeChange> gaussianChange(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, const GridGaussian& gaussian,
    const Progress& progress);

/// What several segments gain, and which of their voxels become free.
struct JointChange {
    /// For each segment, the voxels that it gains: free ones, and those of the others.
    std::vector<VoxelRuns> given;
    VoxelRuns freed;
};

/// Smooths several segments together. Each is blurred, and so is the region that no segment has. A
/// voxel that belongs to one of them, or to no segment, goes to the one whose blurred value is
/// greatest there; on a tie to the lowest label, where free space counts as label 0. If all values
/// are 0 it does not change. So no gap opens between neighbours. Voxels of other segments keep
/// their label and count for none of these values, so no gap opens beside them either.
///
/// Cost: a blurring of the box around each segment, and one of the box around all.
/// @param segments their labels, ascending
/// @param number for progress: which part of the work this is, of @p of parts
/// Any thread outside a parallelFor(). Errors: OutOfMemory, Cancelled.
[[nodiscard]] Result<JointChange> jointGaussianChange(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::span<const std::uint8_t> segments, const GridGaussian& gaussian,
    const Progress& progress, int number = 0, int of = 1);

} // namespace core
