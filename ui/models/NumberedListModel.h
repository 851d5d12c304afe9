// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"

#include <QAbstractListModel>

#include <vector>

namespace ui {

class Workspace;

/// Base of item models for lists of the document whose members have numbers: sculpt layers and
/// pieces. Members are changed through the session, as steps of undo.
class NumberedListModel : public QAbstractListModel {
    Q_OBJECT

public:
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] int rowOf(int number) const; ///< -1: none

protected:
    NumberedListModel(Workspace& workspace, QObject* parent);

    [[nodiscard]] virtual std::vector<int> numbers(const core::Document& document) const = 0;
    /// Reads the list again. If its members have changed this is a model reset, else all data may
    /// have changed.
    void refresh();
    /// 0 if there is no such row, or no session.
    [[nodiscard]] int numberAt(const QModelIndex& index) const;
    /// @return whether the edit was carried out; an error was reported to the user
    bool apply(const core::Edit& edit);

    Workspace& m_workspace;

private:
    std::vector<int> m_numbers; ///< the numbers that were last announced to the views
};

} // namespace ui
