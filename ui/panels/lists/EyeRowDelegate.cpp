// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/EyeRowDelegate.h"

#include "ui/base/Icons.h"
#include "ui/base/Theme.h"

#include <QMouseEvent>
#include <QPainter>

namespace ui {

namespace {

constexpr int nameLeft = 40;

} // namespace

void paintRowGround(QPainter* painter, const QStyleOptionViewItem& option, bool active)
{
    if (active || option.state.testFlag(QStyle::State_MouseOver))
        painter->fillRect(option.rect, active ? theme::selected : theme::raised);
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        painter->setPen(QPen(theme::accent, 1.0));
        painter->drawRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void paintEye(QPainter* painter, const QRect& row, bool open, const QColor& ink)
{
    painter->drawPixmap(EyeRowDelegate::eyeRect(row),
        tintedIcon(open ? QStringLiteral("eye") : QStringLiteral("eye-off"), ink, 20,
            painter->device()->devicePixelRatioF()));
}

const QMouseEvent* leftClick(const QEvent* event)
{
    if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseButtonRelease
        && event->type() != QEvent::MouseButtonDblClick)
        return nullptr;
    const auto* mouse = static_cast<const QMouseEvent*>(event);
    return mouse->button() == Qt::LeftButton ? mouse : nullptr;
}

QRect EyeRowDelegate::eyeRect(const QRect& row)
{
    return {row.left() + 10, row.top() + (row.height() - 20) / 2, 20, 20};
}

QRect EyeRowDelegate::nameRect(const QRect& row) const
{
    return {row.left() + nameLeft, row.top(), row.width() - nameLeft - stateWidth(), row.height()};
}

QSize EyeRowDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const
{
    return {160, rowHeight};
}

void EyeRowDelegate::paint(
    QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const Row shown = row(index);
    const QColor ink = shown.counts ? theme::text : theme::secondary;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    paintRowGround(painter, option, shown.active);
    paintEye(painter, option.rect, shown.eyeOpen, ink);
    const QRect name = nameRect(option.rect);
    painter->setFont(option.font);
    painter->setPen(ink);
    painter->drawText(name, Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetrics(option.font)
            .elidedText(index.data().toString(), Qt::ElideRight, name.width() - 4));
    painter->setFont(theme::smallFont());
    painter->setPen(shown.stateColour);
    painter->drawText(
        option.rect.adjusted(0, 0, -10, 0), Qt::AlignRight | Qt::AlignVCenter, shown.state);
    painter->restore();
}

bool EyeRowDelegate::editorEvent(QEvent* event, QAbstractItemModel* model,
    const QStyleOptionViewItem& option, const QModelIndex& index)
{
    const QMouseEvent* click = leftClick(event);
    const QRect eye = eyeRect(option.rect).adjusted(-6, -4, 8, 4);
    if (click && eye.contains(click->position().toPoint())) {
        if (event->type() == QEvent::MouseButtonRelease)
            eyeClicked(*model, index, click->modifiers());
        return true;
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
}

void EyeRowDelegate::updateEditorGeometry(
    QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const
{
    editor->setGeometry(nameRect(option.rect).adjusted(-8, 1, 0, -1));
}

} // namespace ui
