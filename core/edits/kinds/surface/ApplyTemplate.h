// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/surface/parts/SurfaceRules.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// Fit the red part of the surface to contours that were drawn on planes.
struct ApplyTemplate {
    std::vector<std::vector<glm::dvec3>> contoursLps{};
    SurfaceRules rules{};
};

[[nodiscard]] Result<void> check(const ApplyTemplate& edit, const Document& document);
Result<bool> apply(const ApplyTemplate& edit, Document& document);
[[nodiscard]] EditEffects effects(const ApplyTemplate& edit);
[[nodiscard]] RowTitle rowTitle(const ApplyTemplate& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ApplyTemplate& edit, const DependencyFacts& row);
[[nodiscard]] OpenManner openManner(const ApplyTemplate& edit);

} // namespace core
