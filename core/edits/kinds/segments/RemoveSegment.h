// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

namespace core {

struct EraseLabel;

/// Delete a segment with its voxels, seeds and growth. Its label is not used again.
struct RemoveSegment {
    int segment = 0; ///< label
};

[[nodiscard]] Result<void> check(const RemoveSegment& edit, const Document& document);
Result<bool> apply(const RemoveSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const RemoveSegment& edit);
[[nodiscard]] RowTitle rowTitle(const RemoveSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const RemoveSegment& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const RemoveSegment& edit, const Document& document);

/// Errors: UnknownSegment, SegmentLocked.
[[nodiscard]] Result<EraseLabel> eraseLabel(const RemoveSegment& edit, const Document& document);

} // namespace core
