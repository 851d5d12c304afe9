// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/surface/parts/SurfacePath.h"

namespace core {

/// Drag the vertex nearest to the first point; its surroundings follow like a rubber sheet.
struct PointDrag {
    SurfacePath path{};
};

[[nodiscard]] Result<void> check(const PointDrag& edit, const Document& document);
Result<bool> apply(const PointDrag& edit, Document& document);
[[nodiscard]] EditEffects effects(const PointDrag& edit);
[[nodiscard]] RowTitle rowTitle(const PointDrag& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const PointDrag& edit, const DependencyFacts& row);

} // namespace core
