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

/// Give a segment that was drawn on some slices what lies between them
/// (core/morphology/BetweenSlices.h). Like CleanSegment it is worked out anew from the labels
/// whenever it is carried out. Slices that have voxels of the segment are the drawn ones, and stay
/// as they are.
struct FillBetweenSlices {
    int segment = 0; ///< label
    std::optional<SliceAxis> axis{}; ///< none: the one across which it was drawn
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
};

[[nodiscard]] Result<void> check(const FillBetweenSlices& edit, const Document& document);
Result<bool> apply(const FillBetweenSlices& edit, Document& document);
[[nodiscard]] EditEffects effects(const FillBetweenSlices& edit);
[[nodiscard]] RowTitle rowTitle(const FillBetweenSlices& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(
    const FillBetweenSlices& edit, const DependencyFacts& row);

/// The edit for an engine; no bricks: there is nothing to be done. It takes only voxels that no
/// segment has.
/// @param labels of the whole volume in the segment's plane, x fastest
/// Any thread that is no parallelFor's. Errors: UnknownSegment, SegmentLocked, OutOfMemory,
/// Cancelled.
[[nodiscard]] Result<RelabelListed> relabelListed(const FillBetweenSlices& edit,
    const Document& document, std::span<const std::uint8_t> labels, const Progress& progress);

} // namespace core
