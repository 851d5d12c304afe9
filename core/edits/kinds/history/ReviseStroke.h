// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <cstdint>
#include <optional>

namespace core {

/// Changes or removes an earlier cut of the history; what later strokes cut stays
/// (session/operations/history/ReviseOperation.h). Absent fields are as in the original row, not as
/// in an earlier revision. StrokeParameters says which fields a cut has.
struct ReviseStroke {
    std::int64_t row = 0; ///< RowId
    std::optional<double> radiusMm{};
    std::optional<double> sideMm{}; ///< of a square mask
    std::optional<double> widthMm{}; ///< of an ellipse, rectangle or rounded rectangle
    std::optional<double> heightMm{};
    std::optional<double> factor{}; ///< of a drawn outline: scales it
    std::optional<double> depthMm{};
    std::optional<double> softnessMm{};
    std::optional<int> layer{};
    std::optional<bool> throughGaps{};
    bool removed = false;
};

[[nodiscard]] Result<void> check(const ReviseStroke& edit, const Document& document);
Result<bool> apply(const ReviseStroke& edit, Document& document);
[[nodiscard]] EditEffects effects(const ReviseStroke& edit);
[[nodiscard]] RowTitle rowTitle(const ReviseStroke& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ReviseStroke& edit, const DependencyFacts& row);
[[nodiscard]] RowUse rowUse(const ReviseStroke& edit);

} // namespace core
