// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/PieceDelegate.h"

#include "ui/Icons.h"
#include "ui/Theme.h"
#include "ui/models/PieceListModel.h"

#include <QMouseEvent>
#include <QPainter>

namespace ui {

namespace {

constexpr int nameLeft = 40;
constexpr int stateWidth = 116;

QRect nameRect(const QRect& row)
{
    return {row.left() + nameLeft, row.top(), row.width() - nameLeft - stateWidth, row.height()};
}

} // namespace

QRect PieceDelegate::eyeRect(const QRect& row)
{
    return {row.left() + 10, row.top() + (row.height() - 20) / 2, 20, 20};
}

QSize PieceDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const
{
    return {160, rowHeight};
}

void PieceDelegate::paint(
    QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const QRect row = option.rect;
    const bool active = index.data(PieceListModel::ActiveRole).toBool();
    const bool hidden = !index.data(PieceListModel::VisibleRole).toBool();
    const QString badge = index.data(PieceListModel::BadgeRole).toString();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (active || option.state.testFlag(QStyle::State_MouseOver))
        painter->fillRect(row, active ? theme::selected : theme::raised);
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        painter->setPen(QPen(theme::accent, 1.0));
        painter->drawRect(QRectF(row).adjusted(0.5, 0.5, -0.5, -0.5));
    }
    painter->drawPixmap(eyeRect(row),
        tintedIcon(hidden ? QStringLiteral("eye-off") : QStringLiteral("eye"),
            hidden ? theme::secondary : theme::text, 20, painter->device()->devicePixelRatioF()));
    painter->setFont(option.font);
    painter->setPen(hidden ? theme::secondary : theme::text);
    painter->drawText(nameRect(row), Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetrics(option.font)
            .elidedText(index.data().toString(), Qt::ElideRight, nameRect(row).width() - 4));
    painter->setFont(theme::smallFont());
    painter->setPen(badge.isEmpty() ? theme::secondary : theme::caution);
    painter->drawText(row.adjusted(0, 0, -10, 0), Qt::AlignRight | Qt::AlignVCenter,
        badge.isEmpty() ? tr("at home") : badge);
    painter->restore();
}

bool PieceDelegate::editorEvent(QEvent* event, QAbstractItemModel* model,
    const QStyleOptionViewItem& option, const QModelIndex& index)
{
    const bool press = event->type() == QEvent::MouseButtonPress;
    const bool release = event->type() == QEvent::MouseButtonRelease;
    const bool twice = event->type() == QEvent::MouseButtonDblClick;
    if (press || release || twice) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const bool eye =
            eyeRect(option.rect).adjusted(-6, -4, 8, 4).contains(mouse->position().toPoint());
        if (mouse->button() == Qt::LeftButton && eye) {
            // On release, so that a click begun elsewhere does nothing; a double click is two.
            if (release)
                model->setData(index, !index.data(PieceListModel::VisibleRole).toBool(),
                    PieceListModel::VisibleRole);
            return true;
        }
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
}

void PieceDelegate::updateEditorGeometry(
    QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const
{
    editor->setGeometry(nameRect(option.rect).adjusted(-8, 1, 0, -1));
}

} // namespace ui
