// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/FollowedInterval.h"

namespace core {

namespace {

bool isUnlimited(const ThresholdSegment& threshold)
{
    return !threshold.onlyVisible && !threshold.box && !threshold.editable;
}

bool hasSameLimits(const ThresholdSegment& one, const ThresholdSegment& other)
{
    return one.onlyVisible == other.onlyVisible && one.box == other.box
        && one.editable == other.editable;
}

} // namespace

std::optional<ThresholdSegment> followedInterval(const Segment& segment, const History& history)
{
    const RowId row = segment.followsRow;
    if (row <= 0 || row > RowId(history.rows().size()))
        return std::nullopt;
    const auto* threshold = history.row(row).edit.as<ThresholdSegment>();
    return threshold ? std::optional(*threshold) : std::nullopt;
}

bool givesAllOf(const ThresholdSegment& threshold, bool wasEmpty,
    const std::optional<ThresholdSegment>& followed)
{
    if (threshold.mode != ThresholdSegment::Mode::Replace)
        return false;
    return isUnlimited(threshold) || wasEmpty || (followed && hasSameLimits(threshold, *followed));
}

void followIntervals(
    RowId row, const Edit& edit, const EditStatistics& statistics, Document& document)
{
    for (const int label : statistics.intervalsLeft) {
        if (Segment* segment = document.segment(label))
            segment->followsRow = 0;
    }
    const auto* threshold = edit.as<ThresholdSegment>();
    if (!threshold || !statistics.followsInterval)
        return;
    if (Segment* segment = document.segment(threshold->segment))
        segment->followsRow = row;
}

} // namespace core
