// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/brick/VoxelRuns.h"
#include "core/volume/VolumeGeometry.h"

#include <span>
#include <vector>

namespace core {

/// What is examined: the labels of a segment's plane, and the values around the segment.
struct BorderSource {
    const VolumeGeometry& geometry;
    std::span<const std::uint8_t> labels; ///< one for each voxel of the volume, x fastest
    std::uint8_t label = 0;
    VoxelBox box; ///< the box that boxAroundBorder() returns
    std::span<const std::uint16_t> codes; ///< one for each voxel of the box, x fastest
};

/// The part of the volume whose values are needed: the box around the segment, extended by two
/// voxels on all sides within the volume; empty if the segment has no voxels. Cost: one pass over
/// the volume.
[[nodiscard]] VoxelBox boxAroundBorder(
    std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label);

/// Parts of the border of a segment where the values show no edge. All computed in whole numbers:
///
/// 1. A voxel of the segment belongs to the border if it shares a face with a voxel of the volume
///    that is not the segment's.
/// 2. Its direction is the sum of the directions in which such faces point. Around it, the voxels
///    are taken that lie up to twice the finest spacing away along each axis (one or two voxels)
///    and within 1½ voxels of the line through it in this direction; if the faces cancel out, all
///    around it. So at the end of a thin vessel the values are compared with those where the vessel
///    goes on.
/// 3. The contrast is the greater of two numbers: the difference between the mean values outside
///    and inside; and how much farther the values outside are on average from the mean inside than
///    those inside are. The second also finds an edge where one neighbour is brighter and another
///    darker. Using this many values evens out noise.
/// 4. There is no edge where the contrast is less than a quarter of the median over the whole
///    border.
/// 5. Voxels without an edge that touch, be it at a corner, form a part.
class FaintBorder {
public:
    struct Part {
        VoxelRuns voxels;
        std::int64_t areaUm2 = 0;
        std::int64_t doubt = 0; ///< the area, where each voxel counts less the more contrast it has
    };

    /// Examines a segment. Cost: up to 5³ voxels are read for each voxel of the border, on all
    /// cores. Any thread. Errors: Cancelled.
    [[nodiscard]] static Result<FaintBorder> of(
        const BorderSource& source, const Progress& progress);

    /// The parts that have at least nine voxels and at least a thousandth of the area of the whole
    /// border, in descending order of doubt.
    std::vector<Part> parts;
    std::int64_t wholeAreaUm2 = 0;
};

} // namespace core
