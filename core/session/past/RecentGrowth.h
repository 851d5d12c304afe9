// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/history/History.h"

#include <bitset>
#include <optional>

namespace core {

struct GrowCriteria;

/// The criteria of the last growth in effect, including changes of its interval; none: nothing has
/// grown.
[[nodiscard]] std::optional<GrowCriteria> recentCriteria(const History& history);

/// The labels of the segments that have seeds, sketched or painted, and may grow: they exist and
/// are not locked.
[[nodiscard]] std::bitset<256> growingSegments(const History& history, const Document& document);

/// Whether a growth in effect has begun at seeds of a segment; perhaps nothing of it is left.
[[nodiscard]] bool hasGrown(const History& history, int segment);

/// Whether an edit changes how later growths continue, even if it changes no voxel: its criteria
/// are new, and there are sketched seeds that may still be admitted.
[[nodiscard]] bool bringsNewCriteria(const Edit& edit, const History& history);

/// Writes into a growth what it would otherwise read in the history, so that the edit alone
/// determines the result: ResumeGrowth becomes the GrowSteps that it stands for; ChangeInterval
/// receives all criteria and whether it begins at the seeds. Other edits are not changed. Errors:
/// InvalidField (nothing has grown).
[[nodiscard]] Result<void> nameWhatGrowthReads(
    Edit& edit, const History& history, const Document& document);

} // namespace core
