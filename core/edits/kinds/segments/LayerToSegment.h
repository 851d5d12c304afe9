// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/edits/kinds/parts/SegmentChoice.h"

namespace core {

struct LabelCarved;

/// Add what a layer has carved (coverage ≥ 128) to a segment.
struct LayerToSegment {
    int layer = 0; ///< id
    SegmentChoice target{};
    bool overwriteUnlocked = false;
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
};

[[nodiscard]] Result<void> check(const LayerToSegment& edit, const Document& document);
Result<bool> apply(const LayerToSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const LayerToSegment& edit);
[[nodiscard]] RowTitle rowTitle(const LayerToSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const LayerToSegment& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const LayerToSegment& edit, const Document& document);

/// Errors: those of labelTarget() (EngineEdits.h), InvalidField (no such layer).
[[nodiscard]] Result<LabelCarved> labelCarved(const LayerToSegment& edit, const Document& document);

} // namespace core
