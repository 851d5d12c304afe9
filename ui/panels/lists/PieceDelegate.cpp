// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/PieceDelegate.h"

#include "ui/base/Theme.h"
#include "ui/models/PieceListModel.h"

namespace ui {

EyeRowDelegate::Row PieceDelegate::row(const QModelIndex& index) const
{
    const bool visible = index.data(PieceListModel::VisibleRole).toBool();
    const QString badge = index.data(PieceListModel::BadgeRole).toString();
    return {.active = index.data(PieceListModel::ActiveRole).toBool(),
        .eyeOpen = visible,
        .counts = visible,
        .state = badge.isEmpty() ? tr("at home") : badge,
        .stateColour = badge.isEmpty() ? theme::secondary : theme::caution};
}

void PieceDelegate::eyeClicked(
    QAbstractItemModel& model, const QModelIndex& index, Qt::KeyboardModifiers)
{
    model.setData(
        index, !index.data(PieceListModel::VisibleRole).toBool(), PieceListModel::VisibleRole);
}

} // namespace ui
