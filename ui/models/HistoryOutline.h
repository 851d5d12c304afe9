// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <map>
#include <set>
#include <vector>

namespace ui {

/// One entry of the history's list: the opened study, a row, a way of viewing that was changed at a
/// row, or the heading of a branch.
struct HistoryEntry {
    core::RowId row = 0; ///< 0: the study as opened; of a heading: the branch's last row
    core::RowId branch = 0; ///< first row of the branch that it belongs to; 0: the current line
    int depth = 0; ///< 0: the current line, 1: a branch of it, 2: a branch of a branch …
    int lineIndex = 0; ///< its place on the current line, or that of the row its branch hangs under
    int steps = 0; ///< of a heading: rows of the branch; 0: no heading
    int viewStep = 0; ///< 1, 2 …: the change of what is shown that was made at the row; 0: none
    bool folded = false; ///< a heading whose rows are not listed
    bool last = false; ///< nothing comes after it on its own line

    [[nodiscard]] bool isHeading() const { return steps > 0; }
};

/// The tree of rows as a list. The current line keeps its order; directly under the row where an
/// old future forks off stands that branch's heading, and where it is unfolded, its rows. A branch
/// runs where redo would go, so that walking to any of its rows makes it the current line as it
/// was listed; what forks off it is a branch of its own, one deeper.
struct HistoryOutline {
    std::vector<HistoryEntry> entries;
    std::vector<core::RowId> line; ///< the current line, the beginning (0) first
    int branches = 0; ///< of any depth, folded away or not

    /// @param unfolded first rows of branches
    /// @param viewSteps how many changes of what is shown stand under a row, where it is on the
    /// current line (ViewSteps)
    /// Cost: linear in the rows of the history.
    [[nodiscard]] static HistoryOutline of(const core::History& history,
        const std::set<core::RowId>& unfolded, const std::map<core::RowId, int>& viewSteps = {});
};

} // namespace ui
