// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/document/Piece.h"
#include "ui/models/NumberedListModel.h"

namespace ui {

/// Item model of the document's pieces. Names are changed through the session, as steps of undo;
/// visibility is display state.
class PieceListModel : public NumberedListModel {
    Q_OBJECT

public:
    enum Role {
        IdRole = Qt::UserRole, ///< int
        VisibleRole, ///< bool; can be set
        ActiveRole, ///< bool
        BadgeRole, ///< "42 mm · 1.5×"; empty: at home
    };

    explicit PieceListModel(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

protected:
    [[nodiscard]] std::vector<int> numbers(const core::Document& document) const override;

private:
    [[nodiscard]] const core::Piece* pieceAt(const QModelIndex& index) const;
};

} // namespace ui
