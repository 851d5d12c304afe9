// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/criteria/GrowGuard.h"

#include <optional>

namespace core {

struct GrowBurst;

/// Give a growth another interval: what qualifies now is recovered, and what no longer qualifies is
/// removed with everything that depended on it (seed A §5.4).
struct ChangeInterval {
    /// With `asBefore` only lower, upper and plane are used.
    GrowCriteria criteria{};
    /// All other criteria are those of the last growth in the plane that is named, or in any plane
    /// if none is. False once it is carried out.
    bool asBefore = true;
    /// The growth is removed down to its seeds and repeated. None: that is decided when it is
    /// carried out; it is done if more than one segment grows or if its criteria are not fixed.
    std::optional<bool> fromSeeds{};
    /// None: to closure. Counted from the seeds if `fromSeeds` is true, otherwise from the present
    /// state.
    std::optional<int> steps{};
    GrowGuard guard{};
};

[[nodiscard]] Result<void> check(const ChangeInterval& edit, const Document& document);
Result<bool> apply(const ChangeInterval& edit, Document& document);
[[nodiscard]] EditEffects effects(const ChangeInterval& edit);
[[nodiscard]] RowTitle rowTitle(const ChangeInterval& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ChangeInterval& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const ChangeInterval& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(ChangeInterval& edit);

/// For an edit that states everything it reads (RecentGrowth.h). Errors: those of GrowSteps.
[[nodiscard]] Result<GrowBurst> growBurst(const ChangeInterval& change, const Document& document);

} // namespace core
