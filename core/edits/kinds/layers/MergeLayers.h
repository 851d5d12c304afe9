// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

namespace core {

struct FoldLayer;

/// Add what one layer has carved to another (the greater coverage counts) and delete the first.
/// Either both layers carve or neither does, so nothing looks different.
struct MergeLayers {
    int from = 0; ///< id
    int into = 0; ///< id
};

[[nodiscard]] Result<void> check(const MergeLayers& edit, const Document& document);
Result<bool> apply(const MergeLayers& edit, Document& document);
[[nodiscard]] EditEffects effects(const MergeLayers& edit);
[[nodiscard]] RowTitle rowTitle(const MergeLayers& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const MergeLayers& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const MergeLayers& edit, const Document& document);

/// Expects layers that exist.
[[nodiscard]] FoldLayer foldLayer(const MergeLayers& edit);

} // namespace core
