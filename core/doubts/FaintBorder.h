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

/// What is looked at: the labels of a segment's plane, and the values around the segment.
struct BorderSource {
    const VolumeGeometry& geometry;
    std::span<const std::uint8_t> labels; ///< of the whole volume, x fastest
    std::uint8_t label = 0;
    VoxelBox box; ///< as boxAroundBorder()
    std::span<const std::uint16_t> codes; ///< of the box, x fastest
};

/// The part of the volume whose values tell of a segment's border: the box around the segment with
/// a rim of two voxels; empty if it has no voxel. Cost: one pass over the volume.
[[nodiscard]] VoxelBox boxAroundBorder(
    std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label);

/// Parts of the border of a segment where the values show no edge.
///
/// Around each voxel of the border (one that has a face to a voxel that is not the segment's; the
/// volume's own border is none) what is inside is compared with what is outside, along the way in
/// which those faces look together: up to two voxels of the finest spacing away, and a voxel and a
/// half aside, so that also the end of a thin vessel is compared with where the vessel goes on. By
/// their means, or by how much further the values outside are from the mean inside than those
/// inside are themselves, which tells an edge also where one neighbour is brighter and the other
/// darker. The greater of both is the contrast; so many values even out noise. Where it is less
/// than a quarter of the median of the whole border, there is no edge. Whole numbers only.
class FaintBorder {
public:
    struct Part {
        VoxelRuns voxels;
        std::int64_t areaUm2 = 0;
        std::int64_t doubt = 0; ///< the area, less where there is some contrast
    };

    /// Cost: a cube of 5³ voxels for each voxel of the border, on all cores. Any thread.
    /// Errors: Cancelled.
    [[nodiscard]] static Result<FaintBorder> of(
        const BorderSource& source, const Progress& progress);

    /// Those worth a look, the most doubtful first: of at least nine voxels, and of a thousandth of
    /// the whole border.
    std::vector<Part> parts;
    std::int64_t wholeAreaUm2 = 0;
};

} // namespace core
