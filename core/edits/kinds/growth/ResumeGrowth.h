// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <optional>

namespace core {

/// Continue the last growth with its own criteria. It is stored as the GrowSteps that it
/// stands for.
struct ResumeGrowth {
    std::optional<int> steps{}; ///< none: to closure
    /// The last one in this label plane, from 0; none: the last one in any plane.
    std::optional<int> plane{};
};

[[nodiscard]] Result<void> check(const ResumeGrowth& edit, const Document& document);
Result<bool> apply(const ResumeGrowth& edit, Document& document);
[[nodiscard]] EditEffects effects(const ResumeGrowth& edit);
[[nodiscard]] RowTitle rowTitle(const ResumeGrowth& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ResumeGrowth& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const ResumeGrowth& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(ResumeGrowth& edit);

} // namespace core
