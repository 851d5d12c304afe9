// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/surface/SurfacePath.h"

#include <glm/glm.hpp>

namespace core {

/// Remove what stands out beyond a plane.
struct PlaneScrape {
    SurfacePath path{};
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< points outwards; approximately a unit vector
};

[[nodiscard]] Result<void> check(const PlaneScrape& edit, const Document& document);
Result<bool> apply(const PlaneScrape& edit, Document& document);
[[nodiscard]] EditEffects effects(const PlaneScrape& edit);
[[nodiscard]] RowTitle rowTitle(const PlaneScrape& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const PlaneScrape& edit, const DependencyFacts& row);

} // namespace core
