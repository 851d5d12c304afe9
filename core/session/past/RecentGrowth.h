// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/history/History.h"

#include <bitset>
#include <cstdint>
#include <optional>

namespace core {

struct GrowCriteria;

/// The criteria of the last growth in effect in a label plane, including changes of its interval;
/// none: nothing has grown there.
/// They may list segments that are gone by now (dropGoneFromRange()).
[[nodiscard]] std::optional<GrowCriteria> recentCriteria(
    const History& history, std::uint8_t plane);
/// Takes segments that are gone from the editable range of criteria: nothing lies inside them.
void dropGoneFromRange(GrowCriteria& criteria, const Document& document);

/// The labels of the segments of a label plane that have seeds, sketched or painted, and may grow:
/// they exist and are not locked.
[[nodiscard]] std::bitset<256> growingSegments(
    const History& history, const Document& document, std::uint8_t plane);

/// The labels for which growths in effect in a label plane have begun at seeds; those of segments
/// that lie elsewhere, or are gone, may be among them.
[[nodiscard]] std::bitset<256> grownIn(const History& history, std::uint8_t plane);
/// Whether a growth in effect has begun at seeds of a segment; perhaps nothing of it is left.
[[nodiscard]] bool hasGrown(const History& history, const Segment& segment);

/// The last row on the way to the position that may have set or removed barriers, in any label
/// plane: they are as they were after it. 0: there are none.
[[nodiscard]] RowId lastBarrierRow(const History& history);

/// Whether an edit changes how later growths continue, even if it changes no voxel: its criteria
/// are new, and there are sketched seeds that may still be admitted.
[[nodiscard]] bool bringsNewCriteria(
    const Edit& edit, const History& history, const Document& document);

/// Writes into a growth what it would otherwise read in the history, so that the edit alone
/// determines the result: ResumeGrowth becomes the GrowSteps that it stands for; ChangeInterval
/// receives all criteria and whether it begins at the seeds. Both continue the last growth in the
/// label plane that they name, or in any if they name none. Other edits are not changed. Errors:
/// InvalidField (nothing has grown there).
[[nodiscard]] Result<void> nameWhatGrowthReads(
    Edit& edit, const History& history, const Document& document);

} // namespace core
