// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <glm/glm.hpp>

#include <optional>

namespace core {

struct CutGrowth;

/// Set a barrier across the neck through which growth came to a place, and remove what grew beyond.
struct PlugLeak {
    glm::dvec3 pointLps{0.0};
    std::optional<int> plane{}; ///< the label plane of the growth (GrowthPlane.h)
};

[[nodiscard]] Result<void> check(const PlugLeak& edit, const Document& document);
Result<bool> apply(const PlugLeak& edit, Document& document);
[[nodiscard]] EditEffects effects(const PlugLeak& edit);
[[nodiscard]] RowTitle rowTitle(const PlugLeak& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const PlugLeak& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const PlugLeak& edit, const Document& document);

/// Errors: InvalidField (a point outside the volume), SegmentLocked (no segment may change).
[[nodiscard]] Result<CutGrowth> cutGrowth(const PlugLeak& plug, const Document& document);

} // namespace core
