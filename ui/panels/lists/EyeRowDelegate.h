// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QStyledItemDelegate>

class QMouseEvent;

namespace ui {

/// Draws the background of a row: tinted if it is the active one, raised under the pointer, with a
/// frame if it has the focus.
void paintRowGround(QPainter* painter, const QStyleOptionViewItem& option, bool active);

/// Draws a row's eye, open or shut.
void paintEye(QPainter* painter, const QRect& row, bool open, const QColor& ink);
/// A press, a release or a double click of the left button; null: something else. What a click does
/// is done on release, so that one begun elsewhere does nothing; a double click is two.
[[nodiscard]] const QMouseEvent* leftClick(const QEvent* event);

/// Draws a row with an eye at its left, a name, and a word of state at its right; the base for the
/// lists of sculpt layers and of pieces. The name is edited in place.
class EyeRowDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    static constexpr int rowHeight = 28;

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
        const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(
        const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
        const QModelIndex& index) override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
        const QModelIndex& index) const override;

    /// The rectangle of a row's eye.
    [[nodiscard]] static QRect eyeRect(const QRect& row);

protected:
    struct Row {
        bool active = false;
        bool eyeOpen = true;
        bool counts = true; ///< false: it is dimmed
        QString state;
        QColor stateColour;
    };
    [[nodiscard]] virtual Row row(const QModelIndex& index) const = 0;
    [[nodiscard]] virtual int stateWidth() const = 0;
    virtual void eyeClicked(
        QAbstractItemModel& model, const QModelIndex& index, Qt::KeyboardModifiers modifiers) = 0;

private:
    [[nodiscard]] QRect nameRect(const QRect& row) const;
};

} // namespace ui
