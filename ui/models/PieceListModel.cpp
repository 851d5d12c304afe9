// SPDX-License-Identifier: Apache-2.0
#include "ui/models/PieceListModel.h"

#include "core/edits/kinds/pieces/ChangePiece.h"
#include "ui/workspace/Pieces.h"
#include "ui/workspace/Workspace.h"

namespace ui {

PieceListModel::PieceListModel(Workspace& workspace, QObject* parent)
    : NumberedListModel(workspace, parent)
{
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Pieces
                || change.what == core::DocumentChange::What::Segments)
                refresh();
        });
    connect(&workspace.pieces(), &Pieces::looksChanged, this, &PieceListModel::refresh);
    connect(&workspace.pieces(), &Pieces::activeChanged, this, &PieceListModel::refresh);
    refresh();
}

std::vector<int> PieceListModel::numbers(const core::Document& document) const
{
    std::vector<int> ids;
    for (const core::Piece& piece : document.pieces)
        ids.push_back(piece.id);
    return ids;
}

const core::Piece* PieceListModel::pieceAt(const QModelIndex& index) const
{
    const int id = numberAt(index);
    return id == 0 ? nullptr : m_workspace.session()->document().piece(id);
}

QVariant PieceListModel::data(const QModelIndex& index, int role) const
{
    const core::Piece* piece = pieceAt(index);
    if (!piece)
        return {};
    const Pieces& pieces = m_workspace.pieces();
    const QString badge = Pieces::badge(pieces.pose(*piece));
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return piece->name;
    case Qt::AccessibleTextRole:
        return tr("%1, %2").arg(piece->name, badge.isEmpty() ? tr("at home") : badge);
    case Qt::ToolTipRole:
        return badge.isEmpty()
            ? tr("%1 is at its true place").arg(piece->name)
            : tr("%1 is shown away from its true place: %2").arg(piece->name, badge);
    case IdRole:
        return piece->id;
    case VisibleRole:
        return pieces.look(piece->id).visible;
    case ActiveRole:
        return piece->id == pieces.active();
    case BadgeRole:
        return badge;
    default:
        return {};
    }
}

bool PieceListModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const core::Piece* piece = pieceAt(index);
    if (!piece)
        return false;
    if (role == VisibleRole) {
        PieceLook look = m_workspace.pieces().look(piece->id);
        look.visible = value.toBool();
        m_workspace.pieces().setLook(piece->id, look);
        return true;
    }
    const QString name = value.toString().trimmed();
    if (role != Qt::EditRole || name.isEmpty() || name == piece->name)
        return false;
    core::ChangePiece edit;
    edit.piece = piece->id;
    edit.name = name;
    return apply(edit);
}

} // namespace ui
