// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

namespace core {

/// Remove a piece. What it was made of stays cut.
struct RemovePiece {
    int piece = 0; ///< id
};

[[nodiscard]] Result<void> check(const RemovePiece& edit, const Document& document);
Result<bool> apply(const RemovePiece& edit, Document& document);
[[nodiscard]] EditEffects effects(const RemovePiece& edit);
[[nodiscard]] RowTitle rowTitle(const RemovePiece& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const RemovePiece& edit, const DependencyFacts& row);

} // namespace core
