// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "ui/settings/SeedValues.h"

#include <QJsonArray>

#include <bitset>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace ui {

/// The interval in which each segment grows, as the window remembers it with the session's display
/// state. An undone segment keeps its interval for redo; another one that receives its label does
/// not get it. When a growth is undone or redone, the segments that it grew get the intervals that
/// they had when the growth that is now the last one was made.
class SegmentIntervals {
public:
    struct Interval {
        double lower = 0.0; ///< modality units
        double upper = 0.0;
        bool byHand = false; ///< the user has set it; no sketch changes it
        double tolerance = usualTolerance; ///< where the slider tight … loose stands, deviations
        bool operator==(const Interval&) const = default;
    };

    /// For another session.
    void clear();
    /// Follows which segments there are, and which growth is the last one; to be called when the
    /// segments or the history have changed.
    void follow(const core::EditSession& session);

    /// @param label 0: while there is no segment
    [[nodiscard]] std::optional<Interval> of(int label) const;
    /// Also for a segment that is about to be made.
    void set(int label, const Interval& interval);
    /// Changes its bounds as the user wants them, wherever the slider stands.
    void setByHand(int label, double lower, double upper);
    /// That of 0, which is then forgotten: the first segment gets it.
    [[nodiscard]] std::optional<Interval> takeFirst();

    [[nodiscard]] QJsonArray json() const;
    /// Replaces everything. Invalid entries, and those of segments that do not exist, are dropped.
    void read(const QJsonArray& json, const core::EditSession& session);

private:
    struct Known {
        int label = 0;
        core::RowId since = 0; ///< a row at which the segment was there, the first one known
        Interval interval;
    };

    [[nodiscard]] const Known* find(int label) const;
    void followSegments(const core::EditSession& session);
    void followGrowth(const core::EditSession& session);
    /// Keeps the intervals with the last growth.
    void remember(const core::EditSession& session);
    /// Goes to the last growth over others, which named these segments.
    void goBack(const core::EditSession& session, const std::bitset<256>& segments);

    std::vector<Known> m_known; ///< also of segments that were undone
    std::map<int, core::RowId> m_since; ///< of the segments that there are, by label
    std::map<int, Interval> m_early; ///< of segments that are about to be made, by label
    /// By the row of a growth, then by label: the intervals when it was made.
    std::map<core::RowId, std::map<int, Interval>> m_then;
    std::size_t m_rows = 0; ///< number of the history's rows when it was followed last
    core::RowId m_position = 0; ///< its position then
};

} // namespace ui
