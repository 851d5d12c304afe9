// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "ui/settings/growth/SeedValues.h"

#include <QJsonArray>

#include <bitset>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace ui {

/// The interval of values in which each segment grows, as the window keeps it in the session's
/// display state. An undone segment keeps its interval for redo; another segment that later gets
/// the same label does not receive it. Undo or redo of a growth gives the segments concerned the
/// intervals that belonged to the growth that is now the last one.
class SegmentIntervals {
public:
    struct Interval {
        double lower = 0.0; ///< modality units
        double upper = 0.0;
        bool byHand = false; ///< the user has set it; later sketches do not change it
        /// Position of the slider "tight … loose", in standard deviations.
        double tolerance = usualTolerance;
        bool operator==(const Interval&) const = default;
    };

    /// To be called when another session is opened.
    void clear();
    /// To be called when segments or the history have changed.
    void follow(const core::EditSession& session);

    /// @param label 0: the interval that waits for the first segment
    [[nodiscard]] std::optional<Interval> of(int label) const;
    /// Sets the interval of a segment, which may also be one that is about to be added.
    void set(int label, const Interval& interval);
    /// Sets the bounds as the user chose them. The tolerance stays, and no sketch will change the
    /// interval.
    void setByHand(int label, double lower, double upper);
    /// Returns and forgets the interval of label 0, for the first segment to take over.
    [[nodiscard]] std::optional<Interval> takeFirst();

    [[nodiscard]] QJsonArray json() const;
    /// Replaces everything. Invalid entries, and those of segments that do not exist, are dropped.
    void read(const QJsonArray& json, const core::EditSession& session);

private:
    struct Known {
        int label = 0;
        /// The row at which the segment was first seen; distinguishes it from others with its
        /// label.
        core::RowId since = 0;
        Interval interval;
    };

    [[nodiscard]] const Known* find(int label) const;
    void followSegments(const core::EditSession& session);
    void followGrowth(const core::EditSession& session);
    /// Keeps the intervals with the last growth.
    void remember(const core::EditSession& session);
    /// Restores the intervals of @p segments from the growth that is now the last one.
    void goBack(const core::EditSession& session, const std::bitset<256>& segments);

    std::vector<Known> m_known; ///< of all segments, including undone ones
    std::map<int, core::RowId> m_since; ///< Known::since of the present segments, by label
    std::map<int, Interval> m_early; ///< intervals of segments that are about to be added, by label
    /// The intervals at the time of each growth, by the growth's row and the segment's label.
    std::map<core::RowId, std::map<int, Interval>> m_then;
    std::size_t m_rows = 0; ///< number of the history's rows at the last follow()
    core::RowId m_position = 0; ///< the history's position at the last follow()
};

} // namespace ui
