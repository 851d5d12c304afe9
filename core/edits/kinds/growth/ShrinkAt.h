// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

struct CutGrowth;

/// Remove some places of a growth and what grew through them, cut off where the passage is
/// narrowest. With `steps` instead, remove what descends from these places, and then their parents,
/// generation by generation. What is nearer to the seeds stays (GrowthCut.h).
struct ShrinkAt {
    std::vector<glm::dvec3> pointsLps{};
    bool onlyHere = false; ///< only the voxels at the points
    bool barrier = true; ///< set a barrier along the cut
    /// Number of steps backwards: the first removes the points and what descends from them, each
    /// further one a generation of parents. None: cut at the narrowest passage, as in sessions from
    /// before this field.
    std::optional<int> steps{};
    std::optional<int> plane{}; ///< the label plane of the growth (GrowthPlane.h)
};

[[nodiscard]] Result<void> check(const ShrinkAt& edit, const Document& document);
Result<bool> apply(const ShrinkAt& edit, Document& document);
[[nodiscard]] EditEffects effects(const ShrinkAt& edit);
[[nodiscard]] RowTitle rowTitle(const ShrinkAt& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ShrinkAt& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const ShrinkAt& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(ShrinkAt& edit);

/// Converts the edit to an engine's command. Errors: InvalidField (no point, a point outside the
/// volume, `steps` together with `onlyHere`), SegmentLocked (no segment may change).
[[nodiscard]] Result<CutGrowth> cutGrowth(const ShrinkAt& shrink, const Document& document);

} // namespace core
