// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStyledItemDelegate>

namespace ui {

/// Draws a row of the segment list: eye, colour, name with its code below, volume, lock, and a
/// shield if sculpting tools leave the segment uncut, and a mark if it follows an interval of
/// values. A click on the eye, the lock or the shield switches it; Ctrl and the eye shows the
/// segment alone, or the others again; a click on the colour, the code or the interval's mark asks
/// for a new one.
class SegmentDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    static constexpr int rowHeight = 40;

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
        const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(
        const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
        const QModelIndex& index) override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
        const QModelIndex& index) const override;

    /// The rectangles of the parts of a row.
    [[nodiscard]] static QRect eyeRect(const QRect& row);
    [[nodiscard]] static QRect colourRect(const QRect& row);
    [[nodiscard]] static QRect lockRect(const QRect& row);
    [[nodiscard]] static QRect shieldRect(const QRect& row);
    [[nodiscard]] static QRect codeRect(const QRect& row);
    [[nodiscard]] static QRect intervalRect(const QRect& row); ///< at the end of the code's

Q_SIGNALS:
    void colourRequested(const QPersistentModelIndex& index);
    void codeRequested(const QPersistentModelIndex& index);
    void intervalRequested(const QPersistentModelIndex& index);
};

} // namespace ui
