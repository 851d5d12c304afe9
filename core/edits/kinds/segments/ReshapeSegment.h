// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/morphology/SegmentShape.h"

#include <cstdint>
#include <optional>
#include <span>

namespace core {

struct RelabelListed;

/// Grow or shrink a segment by a margin, hollow it out, open, close or smooth it, with a ball of
/// millimetres (core/morphology/SegmentShape.h). Like CleanSegment it is worked out anew from the
/// labels whenever it is carried out.
struct ReshapeSegment {
    int segment = 0; ///< label
    ShapeOperation operation = ShapeOperation::Grow;
    /// The margin, the thickness of the shell, or the radius of the ball.
    double mm = 0.0;
    std::optional<ShellPlace> shell{}; ///< of Hollow alone; none: inside
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
};

[[nodiscard]] Result<void> check(const ReshapeSegment& edit, const Document& document);
Result<bool> apply(const ReshapeSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const ReshapeSegment& edit);
[[nodiscard]] RowTitle rowTitle(const ReshapeSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ReshapeSegment& edit, const DependencyFacts& row);

/// The edit for an engine; no bricks: there is nothing to be done. It takes only voxels that no
/// segment has.
/// @param labels of the whole volume in the segment's plane, x fastest
/// Any thread that is no parallelFor's. Errors: UnknownSegment, SegmentLocked, InvalidField (the
/// ball is too small or too large), OutOfMemory, Cancelled.
[[nodiscard]] Result<RelabelListed> relabelListed(const ReshapeSegment& edit,
    const Document& document, std::span<const std::uint8_t> labels, const Progress& progress);

} // namespace core
