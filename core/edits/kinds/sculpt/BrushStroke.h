// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/parts/ProtectedSegments.h"

namespace core {

struct CapsuleCut;

/// Carve along a path, or refill what was carved.
struct BrushStroke {
    int layer = 1;
    BrushPath path{};
    bool restore = false;
    ClipHalfSpaces hidden{};
    ProtectedSegments protectedSegments{};
};

[[nodiscard]] Result<void> check(const BrushStroke& edit, const Document& document);
Result<bool> apply(const BrushStroke& edit, Document& document);
[[nodiscard]] EditEffects effects(const BrushStroke& edit);
[[nodiscard]] RowTitle rowTitle(const BrushStroke& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const BrushStroke& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const BrushStroke& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(BrushStroke& edit);

/// The command without the path. Errors: InvalidField.
[[nodiscard]] Result<CapsuleCut> capsuleCut(const BrushStroke& stroke, const Document& document);

} // namespace core
