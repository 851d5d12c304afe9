// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <cstdint>
#include <vector>

namespace core {

/// "Undo only here": takes older rows of the history back and keeps what came after them. Their
/// bricks must not have been written or read since (session/past/RowDependencies.h).
struct RevertRows {
    std::vector<std::int64_t> rows{}; ///< RowId, ascending
};

[[nodiscard]] Result<void> check(const RevertRows& edit, const Document& document);
Result<bool> apply(const RevertRows& edit, Document& document);
[[nodiscard]] EditEffects effects(const RevertRows& edit);
[[nodiscard]] RowTitle rowTitle(const RevertRows& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const RevertRows& edit, const DependencyFacts& row);
[[nodiscard]] RowUse rowUse(const RevertRows& edit);

} // namespace core
