// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/history/History.h"

#include <optional>

namespace core {

// A segment "follows" an interval of values as long as the last edit that changed its voxels is the
// ThresholdSegment that gave it all of them. Moving the interval then computes the segment anew by
// another ThresholdSegment with the same limits. Which segments follow is derived from the rows on
// the path to the present position, so it is right after undo, in branches and in reopened
// sessions; no voxel is read.

/// The interval that a segment follows, with its limits; none: it follows no interval.
/// @param history that of the segment's document
[[nodiscard]] std::optional<ThresholdSegment> followedInterval(
    const Segment& segment, const History& history);

/// Whether a segment consists after a threshold only of voxels that an interval gave it. That is so
/// if the threshold replaces the segment, and if its limits (box, carved voxels, editable range)
/// keep nothing of it that came from elsewhere.
/// @param wasEmpty whether the segment was empty before
/// @param followed the interval that the segment followed before
[[nodiscard]] bool givesAllOf(const ThresholdSegment& threshold, bool wasEmpty,
    const std::optional<ThresholdSegment>& followed);

/// Records in a document which segments follow an interval after a row, and which no longer do.
/// @param document the state after the edit
void followIntervals(
    RowId row, const Edit& edit, const EditStatistics& statistics, Document& document);

} // namespace core
