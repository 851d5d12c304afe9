// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/HiddenSides.h"
#include "core/edits/kinds/parts/SparedSegments.h"

namespace core {

struct CapsuleCut;

/// Carve along a path, or refill what was carved.
struct BrushStroke {
    int layer = 1;
    BrushPath path{};
    bool restore = false;
    HiddenSides hidden{};
    SparedSegments spared{};
};

[[nodiscard]] Result<void> check(const BrushStroke& edit, const Document& document);
Result<bool> apply(const BrushStroke& edit, Document& document);
[[nodiscard]] EditEffects effects(const BrushStroke& edit);
[[nodiscard]] RowTitle rowTitle(const BrushStroke& edit, const RowFacts& row);
[[nodiscard]] EditReach reach(const BrushStroke& edit, const ReachFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const BrushStroke& edit, const Document& document);

/// The command without the path. Errors: InvalidField.
[[nodiscard]] Result<CapsuleCut> capsuleCut(const BrushStroke& stroke, const Document& document);

} // namespace core
