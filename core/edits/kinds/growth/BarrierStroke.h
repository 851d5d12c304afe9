// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/BrushPath.h"

#include <optional>

namespace core {

struct PaintBarrier;

/// Paint barriers, which growth cannot enter, or erase them.
struct BarrierStroke {
    BrushPath path{};
    bool erase = false;
    std::optional<int> plane{}; ///< the label plane of the growth that it keeps out (GrowthPlane.h)
};

[[nodiscard]] Result<void> check(const BarrierStroke& edit, const Document& document);
Result<bool> apply(const BarrierStroke& edit, Document& document);
[[nodiscard]] EditEffects effects(const BarrierStroke& edit);
[[nodiscard]] RowTitle rowTitle(const BarrierStroke& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const BarrierStroke& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const BarrierStroke& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(BarrierStroke& edit);

/// The command without the path. Errors: InvalidField.
[[nodiscard]] Result<PaintBarrier> paintBarrier(
    const BarrierStroke& stroke, const Document& document);

} // namespace core
