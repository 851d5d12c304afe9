// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/brick/SliceAxis.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <cstdint>
#include <optional>
#include <span>

namespace core {

struct RelabelListed;

/// Fill the slices between those on which a segment was drawn, by shape-based interpolation
/// (core/morphology/BetweenSlices.h). Slices that contain voxels of the segment count as drawn and
/// do not change. Like CleanSegment it stores no voxels: the result is computed from the labels
/// each time it is carried out.
struct FillBetweenSlices {
    int segment = 0; ///< label
    std::optional<SliceAxis> axis{}; ///< none: that of drawnAxis()
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
};

[[nodiscard]] Result<void> check(const FillBetweenSlices& edit, const Document& document);
Result<bool> apply(const FillBetweenSlices& edit, Document& document);
[[nodiscard]] EditEffects effects(const FillBetweenSlices& edit);
[[nodiscard]] RowTitle rowTitle(const FillBetweenSlices& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(
    const FillBetweenSlices& edit, const DependencyFacts& row);
[[nodiscard]] OpenManner openManner(const FillBetweenSlices& edit);

/// The command that carries out the edit; without bricks if there is nothing to do. It takes only
/// voxels that no segment has.
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// Any thread outside a parallelFor(). Errors: UnknownSegment, SegmentLocked, OutOfMemory,
/// Cancelled.
[[nodiscard]] Result<RelabelListed> relabelListed(const FillBetweenSlices& edit,
    const Document& document, std::span<const std::uint8_t> labels, const Progress& progress);

} // namespace core
