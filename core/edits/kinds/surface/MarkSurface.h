// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/surface/parts/SurfacePath.h"
#include "core/refine/mesh/SurfaceMark.h"

namespace core {

/// Paint a mark on the surface.
struct MarkSurface {
    SurfaceMark mark = SurfaceMark::Red;
    SurfacePath path{};
};

[[nodiscard]] Result<void> check(const MarkSurface& edit, const Document& document);
Result<bool> apply(const MarkSurface& edit, Document& document);
[[nodiscard]] EditEffects effects(const MarkSurface& edit);
[[nodiscard]] RowTitle rowTitle(const MarkSurface& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const MarkSurface& edit, const DependencyFacts& row);

} // namespace core
