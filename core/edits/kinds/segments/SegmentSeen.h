// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/edits/kinds/parts/SegmentChoice.h"

#include <optional>

namespace core {

struct LabelSeen;

/// "Segment what I see": add to a segment what is not carved, inside the clip region and within an
/// interval of values. The camera has no influence.
struct SegmentSeen {
    SegmentChoice target{};
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    ClipHalfSpaces hidden{};
    bool overwriteUnlocked = false;
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
};

[[nodiscard]] Result<void> check(const SegmentSeen& edit, const Document& document);
Result<bool> apply(const SegmentSeen& edit, Document& document);
[[nodiscard]] EditEffects effects(const SegmentSeen& edit);
[[nodiscard]] RowTitle rowTitle(const SegmentSeen& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const SegmentSeen& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const SegmentSeen& edit, const Document& document);

/// Errors: those of labelTarget() (EngineEdits.h), InvalidField (lower > upper).
[[nodiscard]] Result<LabelSeen> labelSeen(const SegmentSeen& edit, const Document& document);

} // namespace core
