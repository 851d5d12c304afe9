// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/SegmentDelegate.h"

#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/models/SegmentListModel.h"
#include "ui/panels/lists/EyeRowDelegate.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace ui {

namespace {

constexpr int segmentNameLeft = 66;
constexpr int lockWidth = 22;
constexpr int leastVolumeWidth = 74;
constexpr int intervalWidth = 16;

bool isUnwritten(const QModelIndex& index)
{
    return index.data(SegmentListModel::UnwrittenRole).toBool();
}

QString sizeText(const QModelIndex& index)
{
    const QString size = index.data(SegmentListModel::VolumeRole).toString();
    return isUnwritten(index) ? QStringLiteral("≠ ") + size : size;
}

/// A number that is cut off would be another one: voxels take room from the name.
int volumeWidth(const QModelIndex& index)
{
    return std::max(
        leastVolumeWidth, QFontMetrics(theme::smallFont()).horizontalAdvance(sizeText(index)) + 8);
}

QRect nameRect(const QRect& row, const QModelIndex& index)
{
    return {row.left() + segmentNameLeft, row.top() + 3,
        row.width() - segmentNameLeft - volumeWidth(index) - lockWidth, 18};
}

bool followsInterval(const QModelIndex& index)
{
    return !index.data(SegmentListModel::FollowsRole).toString().isEmpty();
}

} // namespace

QRect SegmentDelegate::eyeRect(const QRect& row)
{
    return EyeRowDelegate::eyeRect(row);
}

QRect SegmentDelegate::colourRect(const QRect& row)
{
    return {row.left() + 40, row.top() + (row.height() - 14) / 2, 14, 14};
}

QRect SegmentDelegate::codeRect(const QRect& row)
{
    return {row.left() + segmentNameLeft, row.top() + 21,
        row.width() - segmentNameLeft - lockWidth - 8, 16};
}

QRect SegmentDelegate::intervalRect(const QRect& row)
{
    const QRect code = codeRect(row);
    return {code.right() - intervalWidth + 1, code.top(), intervalWidth, code.height()};
}

QRect SegmentDelegate::lockRect(const QRect& row)
{
    return {row.right() - lockWidth, row.top() + 4, 16, 16};
}

QRect SegmentDelegate::shieldRect(const QRect& row)
{
    return lockRect(row).translated(0, 17);
}

QSize SegmentDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const
{
    return {160, rowHeight};
}

void SegmentDelegate::paint(
    QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const QRect row = option.rect;
    const bool active = index.data(SegmentListModel::ActiveRole).toBool();
    const bool visible = index.data(SegmentListModel::VisibleRole).toBool();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    paintRowGround(painter, option, active);
    const double ratio = painter->device()->devicePixelRatioF();
    paintEye(painter, row, visible, visible ? theme::text : theme::secondary);
    painter->setPen(Qt::NoPen);
    painter->setBrush(index.data(SegmentListModel::ColourRole).value<QColor>());
    painter->drawRoundedRect(colourRect(row), 3.0, 3.0);

    painter->setFont(option.font);
    painter->setPen(visible ? theme::text : theme::secondary);
    const QRect name = nameRect(row, index);
    painter->drawText(name, Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetrics(option.font)
            .elidedText(index.data().toString(), Qt::ElideRight, name.width()));
    const bool coded = !index.data(SegmentListModel::CodeRole).toStringList().isEmpty();
    painter->setFont(theme::smallFont());
    painter->setPen(coded ? theme::secondary : theme::caution);
    const bool follows = followsInterval(index);
    const int codeWidth = codeRect(row).width() - (follows ? intervalWidth + 4 : 0);
    painter->drawText(codeRect(row), Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetrics(theme::smallFont())
            .elidedText(
                index.data(SegmentListModel::CodeTextRole).toString(), Qt::ElideRight, codeWidth));
    if (follows)
        painter->drawPixmap(intervalRect(row),
            tintedIcon(QStringLiteral("interval"), theme::accent, intervalWidth, ratio));
    painter->setPen(isUnwritten(index) ? theme::caution : theme::secondary);
    const int width = volumeWidth(index);
    const QRect volume(row.right() - lockWidth - width, row.top() + 3, width - 4, 18);
    painter->drawText(volume, Qt::AlignRight | Qt::AlignVCenter, sizeText(index));
    const bool locked = index.data(SegmentListModel::LockedRole).toBool();
    const bool isProtected = index.data(SegmentListModel::ProtectedRole).toBool();
    // What is not on says where to click, to who is looking there.
    const bool looking = option.state.testFlag(QStyle::State_MouseOver);
    if (locked || looking) {
        painter->drawPixmap(lockRect(row),
            tintedIcon(locked ? QStringLiteral("lock") : QStringLiteral("unlock"),
                locked ? theme::text : theme::secondary, 16, ratio));
    }
    if (isProtected || looking) {
        if (!isProtected)
            painter->setOpacity(0.45);
        painter->drawPixmap(shieldRect(row),
            tintedIcon(QStringLiteral("shield"), isProtected ? theme::accent : theme::secondary, 16,
                ratio));
    }
    painter->restore();
}

bool SegmentDelegate::editorEvent(QEvent* event, QAbstractItemModel* model,
    const QStyleOptionViewItem& option, const QModelIndex& index)
{
    if (const QMouseEvent* click = leftClick(event)) {
        const bool release = event->type() == QEvent::MouseButtonRelease;
        const QPoint at = click->position().toPoint();
        const bool eye = eyeRect(option.rect).adjusted(-6, -10, 4, 10).contains(at);
        const bool colour = colourRect(option.rect).adjusted(-5, -13, 5, 13).contains(at);
        const bool interval = followsInterval(index) && intervalRect(option.rect).contains(at);
        const bool code = !interval && codeRect(option.rect).contains(at);
        const bool lock = lockRect(option.rect).adjusted(-3, -4, 4, 0).contains(at);
        const bool shield = shieldRect(option.rect).adjusted(-3, 0, 4, 3).contains(at);
        if (eye || colour || code || lock || shield || interval) {
            if (release && eye && click->modifiers().testFlag(Qt::ControlModifier)) {
                model->setData(index, true, SegmentListModel::AloneRole);
            } else if (release && eye) {
                model->setData(index, !index.data(SegmentListModel::VisibleRole).toBool(),
                    SegmentListModel::VisibleRole);
            } else if (release && lock) {
                model->setData(index, !index.data(SegmentListModel::LockedRole).toBool(),
                    SegmentListModel::LockedRole);
            } else if (release && shield) {
                model->setData(index, !index.data(SegmentListModel::ProtectedRole).toBool(),
                    SegmentListModel::ProtectedRole);
            } else if (release && colour) {
                Q_EMIT colourRequested(index);
            } else if (release && code) {
                Q_EMIT codeRequested(index);
            } else if (release && interval) {
                Q_EMIT intervalRequested(index);
            }
            return eye || colour || lock || shield || interval
                || event->type() == QEvent::MouseButtonDblClick;
        }
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
}

void SegmentDelegate::updateEditorGeometry(
    QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    editor->setGeometry(nameRect(option.rect, index).adjusted(-8, -2, 0, 4));
}

} // namespace ui
