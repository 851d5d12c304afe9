// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

namespace core {

// Edits of the surface that is being refined (seed B §4; core/refine). There is one at a time, of
// one segment; its voxels change by WriteBack alone.

/// Lay a surface around what a segment holds, all yellow; the one that was there goes.
struct LaySurface {
    int segment = 0; ///< label
    /// About so many; 0: as many as it takes for the surface to enclose what the segment holds
    /// (core/refine/fit/MeasuredFit.h).
    int vertices = 0;
};

[[nodiscard]] Result<void> check(const LaySurface& edit, const Document& document);
Result<bool> apply(const LaySurface& edit, Document& document);
[[nodiscard]] EditEffects effects(const LaySurface& edit);
[[nodiscard]] RowTitle rowTitle(const LaySurface& edit, const RowFacts& row);
[[nodiscard]] EditReach reach(const LaySurface& edit, const ReachFacts& row);

} // namespace core
