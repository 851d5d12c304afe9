// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/surface/SurfacePath.h"

namespace core {

/// A ball pushes the surface out from inside of it, and in from outside.
struct SpherePush {
    SurfacePath path{};
};

[[nodiscard]] Result<void> check(const SpherePush& edit, const Document& document);
Result<bool> apply(const SpherePush& edit, Document& document);
[[nodiscard]] EditEffects effects(const SpherePush& edit);
[[nodiscard]] RowTitle rowTitle(const SpherePush& edit, const RowFacts& row);
[[nodiscard]] EditReach reach(const SpherePush& edit, const ReachFacts& row);

} // namespace core
