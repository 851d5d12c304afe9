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
// Each pixel of two neighbouring drawn slices has a signed distance, positive inside: to the
// nearest pixel of the other side. In a slice between them the two are blended by how far it lies
// from either, and what is 0 or more belongs to the segment. The distances are roots of whole
// numbers (SliceDistances.h), and which of two weighted roots is the greater is told by their
// squares, so nothing is rounded.
//
// Several parts of a slice are taken one by one, with those of the other slice that they belong to
// (matchedParts()). Where these overlap they stay where they are. Where they do not, they are laid
// over each other by their centroids, and what becomes of them is moved to where it belongs, by
// whole pixels. A part that belongs to none dwindles to its middle before the other slice, as it
// does in ITK's morphological contour interpolation, which ITK-SNAP and 3D Slicer have.

/// The slices across an axis that have voxels of a label.
struct DrawnSlices {
    SliceAxis axis = SliceAxis::K;
    std::vector<int> slices{}; ///< ascending

    /// Empty ones between them, and runs of these.
    [[nodiscard]] int emptySlices() const;
    [[nodiscard]] int gaps() const;
};
/// Of each axis. @param labels of the whole volume, x fastest
[[nodiscard]] std::array<DrawnSlices, 3> drawnSlices(
    std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label);
/// The axis across which somebody has drawn: the one with the smallest share of drawn slices from
/// the first to the last; none if no axis has an empty one between. Of equal ones the last.
[[nodiscard]] std::optional<SliceAxis> drawnAxis(const std::array<DrawnSlices, 3>& drawn);

/// The free voxels (label 0) that the label receives between its drawn slices. Gaps are worked out
/// side by side. Any thread that is no parallelFor's. Errors: OutOfMemory, Cancelled.
[[nodiscard]] Result<VoxelRuns> voxelsBetween(std::span<const std::uint8_t> labels,
    const VolumeGeometry& geometry, std::uint8_t label, const DrawnSlices& drawn,
    const Progress& progress);

} // namespace core
