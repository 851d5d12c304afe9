// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/surface/parts/SurfacePath.h"

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Remove what stands out beyond a plane.
struct PlaneScrape {
    SurfacePath path{};
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< points outwards; approximately a unit vector
    /// The normal of the slice or cutting plane on which the stroke is drawn: the plane stands
    /// across it and turns with the stroke (seed B §4.4). None: the plane keeps its normal.
    std::optional<glm::dvec3> acrossLps{};
};

[[nodiscard]] Result<void> check(const PlaneScrape& edit, const Document& document);
Result<bool> apply(const PlaneScrape& edit, Document& document);
[[nodiscard]] EditEffects effects(const PlaneScrape& edit);
[[nodiscard]] RowTitle rowTitle(const PlaneScrape& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const PlaneScrape& edit, const DependencyFacts& row);

} // namespace core
