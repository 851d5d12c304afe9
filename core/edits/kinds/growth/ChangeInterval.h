// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/growth/GrowCriteria.h"
#include "core/edits/kinds/growth/GrowGuard.h"

#include <optional>

namespace core {

struct GrowBurst;

/// Give a growth another interval: what qualifies now is recovered, what does not any more is taken
/// back with what hung on it (seed A §5.4).
struct ChangeInterval {
    GrowCriteria criteria{}; ///< with `asBefore` only lower and upper are looked at
    bool asBefore = true; ///< all else as the last growth; false once it is carried out
    /// The growth is taken back to its seeds and made anew; none: where more than one segment
    /// grows, or its criteria are not fixed, which is told once it is carried out.
    std::optional<bool> fromSeeds{};
    /// None: to closure. With `fromSeeds` true counted from the seeds, else from what there is.
    std::optional<int> steps{};
    GrowGuard guard{};
};

[[nodiscard]] Result<void> check(const ChangeInterval& edit, const Document& document);
Result<bool> apply(const ChangeInterval& edit, Document& document);
[[nodiscard]] EditEffects effects(const ChangeInterval& edit);
[[nodiscard]] RowTitle rowTitle(const ChangeInterval& edit, const RowFacts& row);
[[nodiscard]] EditReach reach(const ChangeInterval& edit, const ReachFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const ChangeInterval& edit, const Document& document);

/// Of an interval that names all that it reads (RecentGrowth.h). Errors: as of GrowSteps.
[[nodiscard]] Result<GrowBurst> growBurst(const ChangeInterval& change, const Document& document);

} // namespace core
