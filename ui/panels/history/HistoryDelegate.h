// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStyledItemDelegate>

namespace ui {

/// Draws a row of the history: a bead on the line, the name, and a detail at the right. Undone rows
/// are faint, and the bead of a way of viewing is smaller. Branches stand to the right of the line
/// from which they fork off, on a side line that begins at their heading's arrow; a click on the
/// arrow folds and unfolds them.
class HistoryDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
        const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(
        const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
        const QModelIndex& index) override;

    /// The area in which a click hits the arrow of a heading.
    [[nodiscard]] static QRect arrowRect(const QRect& row, int depth);
};

} // namespace ui
