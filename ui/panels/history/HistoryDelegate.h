// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStyledItemDelegate>

namespace ui {

/// A row of the history: a bead on the line, name, detail at the right; undone rows are faint.
/// Branches stand to the right of the line they fork off, on a side line of their own that begins
/// at their heading's arrow; a click on the arrow folds and unfolds.
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

    /// Where a heading's arrow takes clicks.
    [[nodiscard]] static QRect arrowRect(const QRect& row, int depth);
};

} // namespace ui
