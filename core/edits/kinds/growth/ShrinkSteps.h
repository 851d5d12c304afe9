// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <optional>

namespace core {

struct ShrinkGrowth;

/// Remove what growth added last, generation by generation.
struct ShrinkSteps {
    /// none, or at least as many as there are: only the accepted seeds stay
    std::optional<int> steps{};
    std::optional<int> plane{}; ///< the label plane of the growth (GrowthPlane.h)
};

[[nodiscard]] Result<void> check(const ShrinkSteps& edit, const Document& document);
Result<bool> apply(const ShrinkSteps& edit, Document& document);
[[nodiscard]] EditEffects effects(const ShrinkSteps& edit);
[[nodiscard]] RowTitle rowTitle(const ShrinkSteps& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ShrinkSteps& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const ShrinkSteps& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(ShrinkSteps& edit);

/// Errors: SegmentLocked (no segment may change), InvalidField (a plane without segments).
[[nodiscard]] Result<ShrinkGrowth> shrinkGrowth(
    const ShrinkSteps& shrink, const Document& document);

} // namespace core
