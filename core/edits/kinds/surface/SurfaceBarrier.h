// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

namespace core {

/// Shut the place of the surface to growth, or open it again: every voxel whose centre lies outside
/// and that has one with its centre inside among the 26 around it. No growth passes such a shell,
/// by 6, 18 or 26 neighbours, but where a place stays open by the rules of PaintBarrier. It lies
/// outside so that a growth within can fill all that the surface encloses.
struct SurfaceBarrier {
    bool erase = false; ///< barriers there are opened
};

[[nodiscard]] Result<void> check(const SurfaceBarrier& edit, const Document& document);
Result<bool> apply(const SurfaceBarrier& edit, Document& document);
[[nodiscard]] EditEffects effects(const SurfaceBarrier& edit);
[[nodiscard]] RowTitle rowTitle(const SurfaceBarrier& edit, const RowFacts& row);
[[nodiscard]] EditReach reach(const SurfaceBarrier& edit, const ReachFacts& row);

} // namespace core
