// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/brick/SliceAxis.h"
#include "core/brick/VoxelRuns.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/DrawnPlane.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

struct RelabelListed;
struct VolumeGeometry;

/// Fill the slices between those on which a segment was drawn, by shape-based interpolation
/// (core/morphology/BetweenSlices.h). Slices that contain voxels of the segment count as drawn and
/// do not change. If it was drawn on planes of several directions, these are named, and what lies
/// between them is filled (core/morphology/planes/BetweenPlanes.h). Like CleanSegment it stores no
/// voxels: the result is computed from the labels each time it is carried out.
struct FillBetweenSlices {
    int segment = 0; ///< label
    std::optional<SliceAxis> axis{}; ///< none: that of drawnAxis(), or planes are named
    std::optional<std::vector<DrawnPlane>> planes{}; ///< none: the slices across the axis
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
};

[[nodiscard]] Result<void> check(const FillBetweenSlices& edit, const Document& document);
Result<bool> apply(const FillBetweenSlices& edit, Document& document);
[[nodiscard]] EditEffects effects(const FillBetweenSlices& edit);
[[nodiscard]] RowTitle rowTitle(const FillBetweenSlices& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(
    const FillBetweenSlices& edit, const DependencyFacts& row);
[[nodiscard]] OpenManner openManner(const FillBetweenSlices& edit);

/// The free voxels that the segment would receive, whether or not they may change.
/// @param labels as for relabelListed()
/// Any thread outside a parallelFor(). Errors: InvalidField, OutOfMemory, Cancelled.
[[nodiscard]] Result<VoxelRuns> voxelsFilled(const FillBetweenSlices& edit,
    const VolumeGeometry& geometry, std::span<const std::uint8_t> labels, const Progress& progress);
/// The command that carries out the edit; without bricks if there is nothing to do. It takes only
/// voxels that no segment has.
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// Any thread outside a parallelFor(). Errors: UnknownSegment, SegmentLocked, InvalidField,
/// OutOfMemory, Cancelled.
[[nodiscard]] Result<RelabelListed> relabelListed(const FillBetweenSlices& edit,
    const Document& document, std::span<const std::uint8_t> labels, const Progress& progress);

} // namespace core
