// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

namespace core {

struct FoldLayer;

/// Delete a sculpt layer with what it has carved. The last one cannot be deleted. Its number is not
/// used again.
struct RemoveLayer {
    int layer = 0; ///< id
};

[[nodiscard]] Result<void> check(const RemoveLayer& edit, const Document& document);
Result<bool> apply(const RemoveLayer& edit, Document& document);
[[nodiscard]] EditEffects effects(const RemoveLayer& edit);
[[nodiscard]] RowTitle rowTitle(const RemoveLayer& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const RemoveLayer& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const RemoveLayer& edit, const Document& document);

/// Expects a layer that exists.
[[nodiscard]] FoldLayer foldLayer(const RemoveLayer& edit);

} // namespace core
