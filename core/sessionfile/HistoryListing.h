// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sessionfile/records/SessionContents.h"

#include <QJsonObject>
#include <QStringList>

#include <map>
#include <vector>

namespace core {

/// A branch of the history: the rows from the beginning to a row without children.
struct HistoryBranch {
    RowId tip = 0;
    RowId forksAt = 0; ///< the last row that it shares with the line of undo and redo; 0: none
    std::vector<RowId> rows; ///< those after the fork, oldest first
    bool current = false; ///< the line of undo and redo
};

/// All branches: the current one first, then by tip.
[[nodiscard]] std::vector<HistoryBranch> branchesOf(const History& history);

/// The output of `burin history --json`: {"position", "source": {"studyUid", "seriesUid",
/// "voxelsSha256"}, "commands": [{"seq", "parent", "name", "at", "author", "program", "edit",
/// "voxels", "bytes", "hashBefore", "hashAfter"}], "branches": [{"tip", "forksAt", "seqs",
/// "current"}], "problems": [text]}. Of a damaged session the sound rows are listed, and the
/// problems name the others. The hash is null for a row whose second half never reached the disk;
/// at, author and program are null for a row of a version that did not write them.
/// @param problems of the contents, in words (ui::problemTexts())
[[nodiscard]] QJsonObject historyListing(
    const SessionContents& contents, const QStringList& problems);

/// The rows up to the position as a recipe, with the study on which they were recorded. Run on that
/// study, it ends with the same state hash.
[[nodiscard]] QJsonObject historyAsRecipe(const SessionContents& contents);

/// An edit for a history whose rows have other numbers: some edits name rows (EditNames.h).
/// @param numbers from old to new; it preserves the order of rows. Unknown rows keep their number.
[[nodiscard]] Edit renumbered(const Edit& edit, const std::map<RowId, RowId>& numbers);

} // namespace core
