// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sessionfile/records/SessionContents.h"

#include <QJsonObject>

#include <map>
#include <vector>

namespace core {

/// One line of rows from the beginning to a row without children.
struct HistoryBranch {
    RowId tip = 0;
    RowId forksAt = 0; ///< the last row it shares with the line undo and redo walk; 0: none
    std::vector<RowId> rows; ///< its own, behind the fork, oldest first
    bool current = false; ///< it is the line that undo and redo walk
};

/// Every branch, the current one first, then by tip.
[[nodiscard]] std::vector<HistoryBranch> branchesOf(const History& history);

/// What `burin history --json` prints: {"position", "source": {"studyUid", "seriesUid",
/// "voxelsSha256"}, "commands": [{"seq", "parent", "name", "at", "author", "program", "edit",
/// "voxels", "bytes", "hashBefore", "hashAfter"}], "branches": [{"tip", "forksAt", "seqs",
/// "current"}], "problems": [text]}. Of a damaged session the rows that are sound are listed and
/// the problems name the rest. A row whose second half never reached the disk has null as its hash;
/// one that a version without them wrote has null as at, author and program.
[[nodiscard]] QJsonObject historyListing(const SessionContents& contents);

/// The rows up to the position as a recipe, with the study they were recorded on. Carried out on
/// that study it ends at the same hash.
[[nodiscard]] QJsonObject historyAsRecipe(const SessionContents& contents);

/// The edit as it reads where rows have other numbers: RevertRows and ReviseStroke name rows.
/// @param numbers keeps the order of rows; a row that it does not know keeps its number
[[nodiscard]] Edit renumbered(const Edit& edit, const std::map<RowId, RowId>& numbers);

} // namespace core
