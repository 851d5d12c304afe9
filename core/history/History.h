// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/EditStatistics.h"
#include "core/edits/kinds/Edit.h"
#include "core/history/RowOrigin.h"
#include "core/titles/RowTitle.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace core {

using RowId = std::int64_t; ///< 1, 2, 3 …; 0 stands for the beginning

/// One step of the history: an edit that was carried out.
struct HistoryRow {
    RowId id = 0;
    RowId parent = 0;
    QString name; ///< for people: "Drill 6.2 mm, 214 bricks"; what the chain covers
    /// What the name says, so that it can be worded in another language. None: the row is older
    /// than titles, or the title in its file does not belong to its name.
    std::optional<RowTitle> title{};
    Edit edit; ///< quantised; what replay applies
    EditStatistics statistics;
    RowOrigin origin;
    /// The generation after this row, of the growth in the label plane whose growth it moved
    /// (MovedGrowth.h); of that in plane 0 if it moved none.
    std::uint32_t growthGeneration = 0;
    /// size of the compressed difference; 0 while it is still being made
    std::size_t deltaBytes = 0;
    QByteArray stateHash; ///< hex, of the state after this row; empty while it is being computed
};

/// The history: an append-only tree of rows with a current position. It knows nothing of voxels.
///
/// Undo moves the position to the parent, redo to the child visited last. Nothing is ever
/// rewritten: a new row after an undo starts a branch. Not synchronised; it is used on the
/// session's thread.
class History {
public:
    [[nodiscard]] RowId position() const { return m_position; }
    [[nodiscard]] const std::vector<HistoryRow>& rows() const { return m_rows; }
    [[nodiscard]] const HistoryRow& row(RowId id) const { return m_rows.at(std::size_t(id - 1)); }
    [[nodiscard]] HistoryRow& row(RowId id) { return m_rows.at(std::size_t(id - 1)); }

    [[nodiscard]] bool canUndo() const { return m_position != 0; }
    [[nodiscard]] bool canRedo() const { return redoTarget() != 0; }
    /// The child of the position that was visited last; 0 if there is none.
    [[nodiscard]] RowId redoTarget() const { return childLastVisited(m_position); }
    /// Where redo goes from @p row (0: the beginning); 0 if it has no children.
    [[nodiscard]] RowId childLastVisited(RowId row) const
    {
        return m_lastChild.at(std::size_t(row));
    }
    /// Rows from the beginning to @p id, oldest first.
    [[nodiscard]] std::vector<RowId> pathTo(RowId id) const;
    /// The rows on the way to @p id that are in effect: all but those that another row in effect
    /// took back. Oldest first.
    [[nodiscard]] std::vector<RowId> standing(RowId id) const;
    [[nodiscard]] std::vector<RowId> standing() const { return standing(m_position); }
    /// The rows that undo and redo walk: pathTo(position), then those that redo would bring back.
    [[nodiscard]] std::vector<RowId> line() const;

    /// Appends a row as a child of the position and moves there; sets its id and parent.
    RowId append(HistoryRow row);
    void moveTo(RowId id);

    /// A history that was read from a file.
    /// @param visited parent and the child visited last, where known
    /// @pre ids are 1, 2, 3 …, and every parent comes before its children
    [[nodiscard]] static History restored(std::vector<HistoryRow> rows,
        const std::vector<std::pair<RowId, RowId>>& visited, RowId position);

private:
    std::vector<HistoryRow> m_rows;
    std::vector<RowId> m_lastChild{0}; ///< by parent id
    RowId m_position = 0;
};

} // namespace core
