// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

namespace core {

/// Move a segment to another place in the list.
struct MoveSegment {
    int segment = 0; ///< label
    int place = 0; ///< 1: first; beyond the end: last
};

[[nodiscard]] Result<void> check(const MoveSegment& edit, const Document& document);
Result<bool> apply(const MoveSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const MoveSegment& edit);
[[nodiscard]] RowTitle rowTitle(const MoveSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const MoveSegment& edit, const DependencyFacts& row);

} // namespace core
