// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/criteria/GrowGuard.h"

#include <cstdint>
#include <optional>

namespace core {

struct ChangeFacts;
struct EditStatistics;
struct GrowBurst;

/// Grow all seeded segments by a number of steps (seed A §5.3).
struct GrowSteps {
    GrowCriteria criteria{};
    std::optional<int> steps{}; ///< none: to closure
    /// Record which voxels already had the segment's label when they were claimed, so that
    /// shrinking leaves them. False in sessions of schema 3 and before.
    bool tellsHeld = true;
    GrowGuard guard{};
};

[[nodiscard]] Result<void> check(const GrowSteps& edit, const Document& document);
Result<bool> apply(const GrowSteps& edit, Document& document);
[[nodiscard]] EditEffects effects(const GrowSteps& edit);
[[nodiscard]] RowTitle rowTitle(const GrowSteps& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const GrowSteps& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const GrowSteps& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(GrowSteps& edit);

/// Errors: InvalidField (connectivity other than 6, 18 and 26, lower > upper, a box outside the
/// volume), SegmentLocked (no segment may change).
[[nodiscard]] Result<GrowBurst> growBurst(const GrowSteps& grow, const Document& document);

/// How many steps a burst of growth did after its opening. Admitting seeds at the opening counts as
/// a generation but not as a step.
/// @param first the generation when it opened, after members had left
/// @param statistics, facts of the burst
[[nodiscard]] int grownSteps(
    std::uint32_t first, const EditStatistics& statistics, const ChangeFacts& facts);

} // namespace core
