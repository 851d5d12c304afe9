// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <QAbstractListModel>

namespace ui {

class Workspace;

/// The document's pieces. Names are changed through the session, as steps of undo; visibility is
/// display state.
class PieceListModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        IdRole = Qt::UserRole, ///< int
        VisibleRole, ///< bool; can be set
        ActiveRole, ///< bool
        BadgeRole, ///< "42 mm · 1.5×"; empty: at home
    };

    explicit PieceListModel(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

    [[nodiscard]] int rowOf(int piece) const; ///< -1: none

private:
    void refresh();
    [[nodiscard]] const core::Piece* pieceAt(const QModelIndex& index) const;

    Workspace& m_workspace;
    std::vector<int> m_ids; ///< what the views were last told
};

} // namespace ui
