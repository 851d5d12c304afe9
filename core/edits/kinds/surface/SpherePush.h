// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/surface/parts/SurfacePath.h"

namespace core {

/// Push the surface with a ball: outwards from inside it, inwards from outside.
struct SpherePush {
    SurfacePath path{};
};

[[nodiscard]] Result<void> check(const SpherePush& edit, const Document& document);
Result<bool> apply(const SpherePush& edit, Document& document);
[[nodiscard]] EditEffects effects(const SpherePush& edit);
[[nodiscard]] RowTitle rowTitle(const SpherePush& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const SpherePush& edit, const DependencyFacts& row);

} // namespace core
