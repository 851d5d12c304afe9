// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/fields/FieldManners.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>

namespace ui {

namespace {

bool isField(const QObject* object)
{
    return qobject_cast<const QAbstractSpinBox*>(object) != nullptr
        || qobject_cast<const QComboBox*>(object) != nullptr
        || (qobject_cast<const QAbstractSlider*>(object) != nullptr
            && qobject_cast<const QScrollBar*>(object) == nullptr);
}

/// The number field that a widget is, or is the line of; null: none.
const QWidget* numberField(QObject* object)
{
    if (const auto* box = qobject_cast<QAbstractSpinBox*>(object))
        return box;
    const auto* line = qobject_cast<QLineEdit*>(object);
    return line ? qobject_cast<QAbstractSpinBox*>(line->parentWidget()) : nullptr;
}

bool isOfTheWindow(const QKeyEvent& key)
{
    if (key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo))
        return true;
    const bool plain = (key.modifiers() & ~Qt::ShiftModifier) == Qt::NoModifier;
    return plain && key.key() >= Qt::Key_A && key.key() <= Qt::Key_Z;
}

} // namespace

bool FieldManners::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Polish && isField(watched)) {
        auto* field = static_cast<QWidget*>(watched);
        if (field->focusPolicy() == Qt::WheelFocus)
            field->setFocusPolicy(Qt::StrongFocus);
    }
    if (event->type() == QEvent::Wheel && isField(watched)) {
        const auto* field = static_cast<QWidget*>(watched);
        const bool isList = qobject_cast<const QComboBox*>(watched) != nullptr;
        if (isList || !field->hasFocus()) {
            event->ignore(); // whatever holds it scrolls
            return true;
        }
    }
    if (event->type() == QEvent::ShortcutOverride && numberField(watched)
        && isOfTheWindow(*static_cast<QKeyEvent*>(event))) {
        event->ignore();
        return true;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace ui
