// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"

#include <QAbstractListModel>

#include <vector>

namespace ui {

class Workspace;

/// A list of the document whose members are known by number, in its order: what the lists of sculpt
/// layers and of pieces have in common. Members are changed through the session, as steps of undo.
class NumberedListModel : public QAbstractListModel {
    Q_OBJECT

public:
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] int rowOf(int number) const; ///< -1: none

protected:
    NumberedListModel(Workspace& workspace, QObject* parent);

    [[nodiscard]] virtual std::vector<int> numbers(const core::Document& document) const = 0;
    /// Reads the list again: a reset where it has other members, else all of them may have changed.
    void refresh();
    /// 0: there is no such row, or no session.
    [[nodiscard]] int numberAt(const QModelIndex& index) const;
    /// @return whether it was carried out; what was wrong has been said
    bool apply(const core::Edit& edit);

    Workspace& m_workspace;

private:
    std::vector<int> m_numbers; ///< what the views were last told
};

} // namespace ui
