// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

namespace core {

/// Move a sculpt layer to another place in the list.
struct MoveLayer {
    int layer = 0; ///< id
    int place = 0; ///< 1: first; beyond the end: last
};

[[nodiscard]] Result<void> check(const MoveLayer& edit, const Document& document);
Result<bool> apply(const MoveLayer& edit, Document& document);
[[nodiscard]] EditEffects effects(const MoveLayer& edit);
[[nodiscard]] RowTitle rowTitle(const MoveLayer& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const MoveLayer& edit, const DependencyFacts& row);

} // namespace core
