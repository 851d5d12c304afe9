// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/models/HistoryOutline.h"

#include <QAbstractListModel>

namespace ui {

class Workspace;

/// The history, oldest first: the study as it was opened, then one row per command of the current
/// line, the undone ones last. What was changed of the view at a row, and can be taken back with
/// it, stands under it (ViewSteps). Old futures stand under the row they fork off, each behind a
/// heading that unfolds (HistoryOutline); setData(FoldedRole) folds and unfolds.
class HistoryModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        DetailRole = Qt::UserRole, ///< QString, right-aligned: "57 bricks", "+7 204 voxels"
        CurrentRole, ///< bool: the state that is shown
        UndoneRole, ///< bool: redo brings it back
        VoxelsRole, ///< bool: a step that changed voxels and nothing else
        RowIdRole, ///< qlonglong: core::RowId, 0 for the opened study; of a heading: the last row
        ViewStepRole, ///< int: 1, 2 …: a change of the view that was made at the row; 0: none
        DepthRole, ///< int: 0 on the current line, 1 on a branch, 2 on a branch of a branch …
        HeadingRole, ///< bool: the heading of a branch
        FoldedRole, ///< bool: a heading whose rows are not listed
        LastRole, ///< bool: nothing is listed after it on its own line
        DoneBelowRole, ///< bool: the current line goes on below it with steps that are done
    };

    explicit HistoryModel(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

    /// The row of the state that is shown; -1 while no study is open.
    [[nodiscard]] int currentRow() const { return m_currentRow; }
    /// The current line, the beginning (0) first; empty while no study is open.
    [[nodiscard]] const std::vector<core::RowId>& line() const { return m_outline.line; }
    /// Where on line() the state that is shown stands; -1 while no study is open.
    [[nodiscard]] int linePosition() const { return m_linePosition; }
    /// The entry of the current line's row at @p lineIndex.
    [[nodiscard]] QModelIndex indexOnLine(int lineIndex) const;
    /// The heading of the branch that an entry belongs to; invalid on the current line.
    [[nodiscard]] QModelIndex headingOf(const QModelIndex& index) const;
    /// "41 steps · 2 branches · 312 KB"
    [[nodiscard]] QString summary() const;

Q_SIGNALS:
    /// After every change of the history.
    void currentRowChanged(int row);

private:
    void reset();
    void refresh();
    [[nodiscard]] HistoryOutline outlined(const core::History& rows) const;
    void list(HistoryOutline outline);
    void findPosition();
    [[nodiscard]] const core::History* history() const;
    [[nodiscard]] QVariant headingData(const HistoryEntry& entry, int role) const;
    [[nodiscard]] QVariant rowData(const HistoryEntry& entry, int role) const;
    [[nodiscard]] QVariant viewStepData(const HistoryEntry& entry, int role) const;

    Workspace& m_workspace;
    HistoryOutline m_outline; ///< empty while no study is open
    std::set<core::RowId> m_unfolded; ///< first rows of branches
    core::RowId m_position = 0;
    int m_currentRow = -1;
    int m_linePosition = -1;
};

} // namespace ui
