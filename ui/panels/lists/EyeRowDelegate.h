// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QStyledItemDelegate>

namespace ui {

/// The ground of a row: tinted where it is the active one, raised under the pointer, with a frame
/// where it has the focus.
void paintRowGround(QPainter* painter, const QStyleOptionViewItem& option, bool active);

/// A row with an eye at its left, a name, and a word of state at its right: what the lists of
/// sculpt layers and of pieces have in common. The name is edited in its place.
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

    /// Where the eye of a row lies.
    [[nodiscard]] static QRect eyeRect(const QRect& row);

protected:
    struct Row {
        bool active = false;
        bool eyeOpen = true;
        bool counts = true; ///< else it is dimmed
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
