// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QJsonArray>

#include <map>
#include <optional>
#include <vector>

namespace core {
class EditSession;
}

namespace ui {

/// The interval in which each segment grows, as the window remembers it with the session's display
/// state. An undone segment keeps its interval for redo; another one that receives its label does
/// not get it.
class SegmentIntervals {
public:
    struct Interval {
        double lower = 0.0; ///< modality units
        double upper = 0.0;
        bool byHand = false; ///< the user has set it; no sketch changes it
        bool operator==(const Interval&) const = default;
    };

    /// For another session.
    void clear();
    /// Follows which segments there are; to be called when they or the history have changed.
    void follow(const core::EditSession& session);

    /// @param label 0: while there is no segment
    [[nodiscard]] std::optional<Interval> of(int label) const;
    /// Also for a segment that is about to be made.
    void set(int label, const Interval& interval);
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

    std::vector<Known> m_known; ///< also of segments that were undone
    std::map<int, core::RowId> m_since; ///< of the segments that there are, by label
    std::map<int, Interval> m_early; ///< of segments that are about to be made, by label
};

} // namespace ui
