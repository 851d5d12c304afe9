// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/history/History.h"

#include <optional>

namespace core {

// A segment follows an interval of values as long as the last edit that changed its voxels is the
// ThresholdSegment that gave it all of them. It is then worked out anew by another
// ThresholdSegment with the same limits. Which segments do is derived from the rows on the way to
// the position, so undo, branches and reopened sessions have it by themselves; no voxel is looked
// at.

/// The interval that a segment follows, with its limits; none: it follows none.
/// @param history that of the segment's document
[[nodiscard]] std::optional<ThresholdSegment> followedInterval(
    const Segment& segment, const History& history);

/// Whether all that a segment has after a threshold is what an interval gave it: the threshold is
/// in place of what it had, and its limits (box, what is carved away, editable range) keep nothing
/// of it that came otherwise.
/// @param wasEmpty the segment, before
/// @param followed the interval that it followed before
[[nodiscard]] bool givesAllOf(const ThresholdSegment& threshold, bool wasEmpty,
    const std::optional<ThresholdSegment>& followed);

/// Notes in a document which segments follow an interval after a row, and which do no more.
/// @param document after the edit
void followIntervals(
    RowId row, const Edit& edit, const EditStatistics& statistics, Document& document);

} // namespace core
