// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"

namespace core {

struct MapLabels;

/// The segment receives what no segment has, in the whole volume, and what it had becomes free.
/// Other segments keep their voxels; carved or hidden voxels count like all others. It can stand
/// open as a preview.
struct InvertSegment {
    int segment = 0; ///< label
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
};

[[nodiscard]] Result<void> check(const InvertSegment& edit, const Document& document);
Result<bool> apply(const InvertSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const InvertSegment& edit);
[[nodiscard]] RowTitle rowTitle(const InvertSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const InvertSegment& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const InvertSegment& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(InvertSegment& edit);

/// Errors: UnknownSegment, SegmentLocked.
[[nodiscard]] Result<MapLabels> mapLabels(const InvertSegment& edit, const Document& document);

} // namespace core
