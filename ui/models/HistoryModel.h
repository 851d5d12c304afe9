// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QAbstractListModel>

namespace ui {

class Workspace;

/// The history's line, oldest first: the study as it was opened, then one row per command, the
/// undone ones last. Rows of other branches are not listed.
class HistoryModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        DetailRole = Qt::UserRole, ///< QString, right-aligned: "57 bricks", "+7 204 voxels"
        CurrentRole, ///< bool: the state that is shown
        UndoneRole, ///< bool: redo brings it back
        VoxelsRole, ///< bool: a step that changed voxels
        RowIdRole, ///< qlonglong: core::RowId, 0 for the opened study
    };

    explicit HistoryModel(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

    /// The row of the state that is shown; -1 while no study is open.
    [[nodiscard]] int currentRow() const;
    /// "41 steps · 312 KB"
    [[nodiscard]] QString summary() const;

Q_SIGNALS:
    void currentRowChanged(int row);

private:
    void refresh();
    [[nodiscard]] const core::History* history() const;

    Workspace& m_workspace;
    std::vector<core::RowId> m_rows; ///< starts with 0 while a study is open
    core::RowId m_position = 0;
};

} // namespace ui
