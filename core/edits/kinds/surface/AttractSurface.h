// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/surface/parts/SurfacePath.h"

namespace core {

/// Pull the surface to where values change most.
struct AttractSurface {
    SurfacePath path{};
};

[[nodiscard]] Result<void> check(const AttractSurface& edit, const Document& document);
Result<bool> apply(const AttractSurface& edit, Document& document);
[[nodiscard]] EditEffects effects(const AttractSurface& edit);
[[nodiscard]] RowTitle rowTitle(const AttractSurface& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const AttractSurface& edit, const DependencyFacts& row);

} // namespace core
