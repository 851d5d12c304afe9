// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/surface/parts/SurfacePath.h"

namespace core {

/// Smooth the surface.
struct SmoothSurface {
    SurfacePath path{};
};

[[nodiscard]] Result<void> check(const SmoothSurface& edit, const Document& document);
Result<bool> apply(const SmoothSurface& edit, Document& document);
[[nodiscard]] EditEffects effects(const SmoothSurface& edit);
[[nodiscard]] RowTitle rowTitle(const SmoothSurface& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const SmoothSurface& edit, const DependencyFacts& row);

} // namespace core
