// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/LayerDelegate.h"

#include "ui/Icons.h"
#include "ui/Theme.h"
#include "ui/models/LayerListModel.h"

#include <QMouseEvent>
#include <QPainter>

namespace ui {

namespace {

constexpr int nameLeft = 40;
constexpr int stateWidth = 62;

QRect nameRect(const QRect& row)
{
    return {row.left() + nameLeft, row.top(), row.width() - nameLeft - stateWidth, row.height()};
}

} // namespace

QRect LayerDelegate::eyeRect(const QRect& row)
{
    return {row.left() + 10, row.top() + (row.height() - 20) / 2, 20, 20};
}

QSize LayerDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const
{
    return {160, rowHeight};
}

void LayerDelegate::paint(
    QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const QRect row = option.rect;
    const bool active = index.data(LayerListModel::ActiveRole).toBool();
    const bool muted = index.data(LayerListModel::MutedRole).toBool();
    const bool solo = index.data(LayerListModel::SoloRole).toBool();
    const bool carves = index.data(LayerListModel::CarvesRole).toBool();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (active || option.state.testFlag(QStyle::State_MouseOver))
        painter->fillRect(row, active ? theme::selected : theme::raised);
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        painter->setPen(QPen(theme::accent, 1.0));
        painter->drawRect(QRectF(row).adjusted(0.5, 0.5, -0.5, -0.5));
    }
    painter->drawPixmap(eyeRect(row),
        tintedIcon(muted ? QStringLiteral("eye-off") : QStringLiteral("eye"),
            carves ? theme::text : theme::secondary, 20, painter->device()->devicePixelRatioF()));
    painter->setFont(option.font);
    painter->setPen(carves ? theme::text : theme::secondary);
    painter->drawText(nameRect(row), Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetrics(option.font)
            .elidedText(index.data().toString(), Qt::ElideRight, nameRect(row).width() - 4));
    painter->setFont(theme::smallFont());
    // An active layer that does not carve takes no stroke: the user must know why.
    painter->setPen(!carves && active ? theme::caution : solo ? theme::accent : theme::secondary);
    painter->drawText(row.adjusted(0, 0, -10, 0), Qt::AlignRight | Qt::AlignVCenter,
        muted         ? tr("muted")
            : !carves ? tr("left out")
            : solo    ? tr("solo")
            : active  ? tr("carved")
                      : QString());
    painter->restore();
}

bool LayerDelegate::editorEvent(QEvent* event, QAbstractItemModel* model,
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
            if (release) {
                const int role = mouse->modifiers().testFlag(Qt::AltModifier)
                    ? LayerListModel::SoloRole
                    : LayerListModel::MutedRole;
                model->setData(index, !index.data(role).toBool(), role);
            }
            return true;
        }
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
}

void LayerDelegate::updateEditorGeometry(
    QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const
{
    editor->setGeometry(nameRect(option.rect).adjusted(-8, 1, 0, -1));
}

} // namespace ui
