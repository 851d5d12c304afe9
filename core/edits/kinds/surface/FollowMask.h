// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/surface/parts/SurfaceRules.h"

namespace core {

/// Fit the yellow parts of the surface to the boundary of the segment's present voxels. Red and
/// green parts stay.
struct FollowMask {
    SurfaceRules rules{};
};

[[nodiscard]] Result<void> check(const FollowMask& edit, const Document& document);
Result<bool> apply(const FollowMask& edit, Document& document);
[[nodiscard]] EditEffects effects(const FollowMask& edit);
[[nodiscard]] RowTitle rowTitle(const FollowMask& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const FollowMask& edit, const DependencyFacts& row);

} // namespace core
