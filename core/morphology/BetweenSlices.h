// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/SliceAxis.h"
#include "core/brick/VoxelRuns.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

struct VolumeGeometry;

// Shape-based interpolation between drawn slices (Raya and Udupa 1990; with shapes aligned by their
// centroids, Herman, Zheng and Bucholtz 1992), exactly and in whole numbers.
//
// Each pixel of two neighbouring drawn slices has a signed distance, positive inside the segment:
// to the nearest pixel on the other side of its border. For a slice between them the two distances
// are blended, weighted by how near it is to either slice, and pixels with 0 or more belong to the
// segment. The distances are square roots of whole numbers (SliceDistances.h). Which of two
// weighted roots is greater is decided by comparing their squares, so nothing is rounded.
//
// If a slice has several parts, each is interpolated separately with the parts of the other slice
// that it belongs to (matchedParts()). Parts that overlap stay where they are. Parts that do not
// overlap are aligned by their centroids; the interpolated shape is then moved to the interpolated
// centroid, rounded to whole pixels. A part without a counterpart shrinks towards a pixel in its
// middle and ends before the other slice, as in ITK's morphological contour interpolation, which
// ITK-SNAP and 3D Slicer use.

/// The slices across an axis that contain voxels of a label.
struct DrawnSlices {
    SliceAxis axis = SliceAxis::K;
    std::vector<int> slices{}; ///< ascending

    /// The number of empty slices between them, and of the gaps that these form.
    [[nodiscard]] int emptySlices() const;
    [[nodiscard]] int gaps() const;
};
/// The drawn slices across each of the three axes, x first.
/// @param labels one for each voxel of the volume, x fastest
[[nodiscard]] std::array<DrawnSlices, 3> drawnSlices(
    std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label);
/// The axis across which a user has most likely drawn: the one for which the smallest share of
/// slices is drawn, from the first to the last drawn one. If several are equal, the last of them;
/// none if no axis has an empty slice in between.
[[nodiscard]] std::optional<SliceAxis> drawnAxis(const std::array<DrawnSlices, 3>& drawn);

/// The free voxels (label 0) that the label receives between its drawn slices. Gaps are computed in
/// parallel. Any thread outside a parallelFor(). Errors: OutOfMemory, Cancelled.
[[nodiscard]] Result<VoxelRuns> voxelsBetween(std::span<const std::uint8_t> labels,
    const VolumeGeometry& geometry, std::uint8_t label, const DrawnSlices& drawn,
    const Progress& progress);

} // namespace core
