// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

namespace core {

/// Discard the surface. What was not written back is lost with it, unless this is undone.
struct DropSurface { };

[[nodiscard]] Result<void> check(const DropSurface& edit, const Document& document);
Result<bool> apply(const DropSurface& edit, Document& document);
[[nodiscard]] EditEffects effects(const DropSurface& edit);
[[nodiscard]] RowTitle rowTitle(const DropSurface& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const DropSurface& edit, const DependencyFacts& row);

} // namespace core
