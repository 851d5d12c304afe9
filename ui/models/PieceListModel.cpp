// SPDX-License-Identifier: Apache-2.0
#include "ui/models/PieceListModel.h"

#include "ui/Pieces.h"
#include "ui/Workspace.h"

#include <algorithm>
#include <utility>

namespace ui {

PieceListModel::PieceListModel(Workspace& workspace, QObject* parent)
    : QAbstractListModel(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, &PieceListModel::refresh);
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

void PieceListModel::refresh()
{
    std::vector<int> ids;
    if (const core::EditSession* session = m_workspace.session()) {
        for (const core::Piece& piece : session->document().pieces)
            ids.push_back(piece.id);
    }
    if (ids != m_ids) {
        beginResetModel();
        m_ids = std::move(ids);
        endResetModel();
    } else if (!m_ids.empty()) {
        Q_EMIT dataChanged(index(0), index(int(m_ids.size()) - 1));
    }
}

int PieceListModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_ids.size());
}

int PieceListModel::rowOf(int piece) const
{
    const auto found = std::find(m_ids.begin(), m_ids.end(), piece);
    return found == m_ids.end() ? -1 : int(found - m_ids.begin());
}

const core::Piece* PieceListModel::pieceAt(const QModelIndex& index) const
{
    const core::EditSession* session = m_workspace.session();
    if (!session || !checkIndex(index, CheckIndexOption::IndexIsValid))
        return nullptr;
    return session->document().piece(m_ids[std::size_t(index.row())]);
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
    const auto applied = m_workspace.session()->apply(edit);
    if (!applied)
        m_workspace.fail(applied.error());
    return applied.has_value();
}

Qt::ItemFlags PieceListModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemNeverHasChildren;
}

} // namespace ui
