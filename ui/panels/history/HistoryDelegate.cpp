// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/history/HistoryDelegate.h"

#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/models/HistoryModel.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace ui {

namespace {

constexpr double indent = 18.0;
constexpr int deepest = 4; ///< deeper branches are drawn like these: the panel is narrow
constexpr double beadRadius = 4.0;
constexpr double viewBeadRadius = 2.5; ///< of what is no step, but a way of viewing
constexpr int arrowSize = 14;
constexpr double strokeWidth = 1.5;

double lineX(const QRectF& row, int depth)
{
    return row.left() + theme::padding + 4.0 + indent * std::min(depth, deepest);
}

void drawVertical(QPainter& painter, double x, double top, double bottom, const QColor& colour)
{
    painter.setPen(QPen(colour, strokeWidth, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(x, top), QPointF(x, bottom));
}

/// What runs through and to the entry: the lines that it hangs under, then its own.
void drawLines(QPainter& painter, const QRectF& row, const QModelIndex& index)
{
    const int depth = index.data(HistoryModel::DepthRole).toInt();
    const bool heading = index.data(HistoryModel::HeadingRole).toBool();
    const bool doneBelow = index.data(HistoryModel::DoneBelowRole).toBool();
    const QColor below = doneBelow ? theme::secondary : theme::faint;
    const double middle = row.center().y();
    const double bottom = row.bottom();
    // Whatever a branch forks off goes on below it.
    for (int outer = 0; outer < std::min(depth, deepest); ++outer)
        drawVertical(painter, lineX(row, outer), row.top(), bottom,
            outer == 0 ? below : QColor(theme::faint));
    const double x = lineX(row, depth);
    const bool undone = index.data(HistoryModel::UndoneRole).toBool();
    const QColor above = depth > 0 || undone ? theme::faint : theme::secondary;
    if (heading && depth <= deepest) {
        painter.setPen(QPen(theme::faint, strokeWidth, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(
            QPointF(lineX(row, depth - 1), middle), QPointF(x - arrowSize / 2.0, middle));
    } else if (!heading && index.row() > 0) {
        drawVertical(painter, x, row.top(), middle, above);
    }
    if (!index.data(HistoryModel::LastRole).toBool())
        drawVertical(painter, x, heading ? middle + arrowSize / 2.0 : middle, bottom,
            depth == 0 ? below : QColor(theme::faint));
}

void drawBead(QPainter& painter, const QPointF& at, const QModelIndex& index)
{
    const bool branch = index.data(HistoryModel::DepthRole).toInt() > 0;
    const bool undone = index.data(HistoryModel::UndoneRole).toBool();
    const bool current = index.data(HistoryModel::CurrentRole).toBool();
    painter.setPen(branch ? QPen(theme::secondary, strokeWidth) : QPen(Qt::NoPen));
    painter.setBrush(branch ? theme::panel
            : current       ? theme::accent
            : undone        ? theme::faint
                            : theme::secondary);
    const bool view = index.data(HistoryModel::ViewStepRole).toInt() > 0;
    const double radius = view ? viewBeadRadius
        : branch               ? beadRadius - strokeWidth / 2.0
                               : beadRadius;
    painter.drawEllipse(at, radius, radius);
}

} // namespace

QRect HistoryDelegate::arrowRect(const QRect& row, int depth)
{
    const int x = int(lineX(QRectF(row), depth));
    return {x - arrowSize / 2 - 4, row.top(), arrowSize + 8, row.height()};
}

QSize HistoryDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const
{
    return {120, theme::rowHeight};
}

void HistoryDelegate::paint(
    QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const int depth = index.data(HistoryModel::DepthRole).toInt();
    const bool heading = index.data(HistoryModel::HeadingRole).toBool();
    const bool current = index.data(HistoryModel::CurrentRole).toBool();
    const bool undone = index.data(HistoryModel::UndoneRole).toBool();
    const bool chosen = option.state.testFlag(QStyle::State_MouseOver)
        || option.state.testFlag(QStyle::State_Selected);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (current || chosen)
        painter->fillRect(option.rect, current ? theme::selected : theme::raised);
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        painter->setPen(QPen(theme::accent, 1.0));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5));
    }

    const QRectF row(option.rect);
    const double x = lineX(row, depth);
    drawLines(*painter, row, index);
    if (heading) {
        const bool folded = index.data(HistoryModel::FoldedRole).toBool();
        const QString arrow =
            folded ? QStringLiteral("chevron-right") : QStringLiteral("chevron-down");
        painter->drawPixmap(QPointF(x - arrowSize / 2.0, row.center().y() - arrowSize / 2.0),
            tintedIcon(arrow, theme::text, arrowSize, painter->device()->devicePixelRatioF()));
    } else {
        drawBead(*painter, QPointF(x, row.center().y()), index);
    }

    const QRectF text(
        QPointF(x + 16.0, row.top()), QPointF(row.right() - theme::padding, row.bottom()));
    const QString detail = index.data(HistoryModel::DetailRole).toString();
    painter->setFont(theme::smallFont());
    const double detailWidth =
        detail.isEmpty() ? 0.0 : QFontMetricsF(theme::smallFont()).horizontalAdvance(detail) + 12;
    painter->setPen(theme::secondary);
    painter->drawText(text, Qt::AlignRight | Qt::AlignVCenter, detail);
    painter->setFont(option.font);
    painter->setPen(undone || depth > 0 ? theme::secondary : theme::text);
    const QString name =
        QFontMetricsF(option.font)
            .elidedText(index.data().toString(), Qt::ElideRight, text.width() - detailWidth);
    painter->drawText(text, Qt::AlignLeft | Qt::AlignVCenter, name);
    painter->restore();
}

bool HistoryDelegate::editorEvent(QEvent* event, QAbstractItemModel* model,
    const QStyleOptionViewItem& option, const QModelIndex& index)
{
    const bool release = event->type() == QEvent::MouseButtonRelease;
    const bool twice = event->type() == QEvent::MouseButtonDblClick;
    if ((release || twice) && index.data(HistoryModel::HeadingRole).toBool()) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const QRect arrow = arrowRect(option.rect, index.data(HistoryModel::DepthRole).toInt());
        if (mouse->button() == Qt::LeftButton && arrow.contains(mouse->position().toPoint())) {
            // A double click on the arrow is two clicks, and does not walk.
            if (release)
                model->setData(index, !index.data(HistoryModel::FoldedRole).toBool(),
                    HistoryModel::FoldedRole);
            return true;
        }
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
}

} // namespace ui
