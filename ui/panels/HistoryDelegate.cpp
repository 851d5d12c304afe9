// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/HistoryDelegate.h"

#include "ui/Theme.h"
#include "ui/models/HistoryModel.h"

#include <QPainter>

namespace ui {

QSize HistoryDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const
{
    return {120, theme::rowHeight};
}

void HistoryDelegate::paint(
    QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const bool current = index.data(HistoryModel::CurrentRole).toBool();
    const bool undone = index.data(HistoryModel::UndoneRole).toBool();
    const bool pointedAt = option.state.testFlag(QStyle::State_MouseOver);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (current || pointedAt)
        painter->fillRect(option.rect, current ? theme::selected : theme::raised);
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        painter->setPen(QPen(theme::accent, 1.0));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5));
    }

    const QRectF row(option.rect);
    const double x = row.left() + theme::padding + 4.0;
    const QColor line = undone ? theme::line : theme::secondary;
    painter->setPen(QPen(line, 1.5));
    if (index.row() > 0)
        painter->drawLine(QPointF(x, row.top()), QPointF(x, row.center().y()));
    if (index.row() + 1 < index.model()->rowCount()) {
        painter->setPen(QPen(undone || current ? theme::line : theme::secondary, 1.5));
        painter->drawLine(QPointF(x, row.center().y()), QPointF(x, row.bottom() + 1.0));
    }
    painter->setPen(Qt::NoPen);
    painter->setBrush(current ? theme::accent : line);
    painter->drawEllipse(QPointF(x, row.center().y()), 4.0, 4.0);

    const QRectF text = row.adjusted(theme::padding + 20.0, 0.0, -theme::padding, 0.0);
    const QString detail = index.data(HistoryModel::DetailRole).toString();
    painter->setFont(theme::smallFont());
    const double detailWidth =
        detail.isEmpty() ? 0.0 : QFontMetricsF(theme::smallFont()).horizontalAdvance(detail) + 12;
    painter->setPen(theme::secondary);
    painter->drawText(text, Qt::AlignRight | Qt::AlignVCenter, detail);
    painter->setFont(option.font);
    painter->setPen(undone ? theme::secondary : theme::text);
    const QString name =
        QFontMetricsF(option.font)
            .elidedText(index.data().toString(), Qt::ElideRight, text.width() - detailWidth);
    painter->drawText(text, Qt::AlignLeft | Qt::AlignVCenter, name);
    painter->restore();
}

} // namespace ui
