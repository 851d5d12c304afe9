// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/PointedPreview.h"

#include "ui/dialogs/segment/PreviewRow.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QKeySequence>
#include <QLineEdit>
#include <QWidget>

#include <utility>

namespace ui {

namespace {

/// A button has the focus after a click, too, but then nobody looks for what it would do.
bool comesByKeyboard(const QObject& widget, const QFocusEvent& event)
{
    return event.reason() == Qt::TabFocusReason || event.reason() == Qt::BacktabFocusReason
        || qobject_cast<const QAbstractSpinBox*>(&widget);
}

/// Whether an object is a number field, or the line of text in one.
bool isOfNumberField(const QObject& object)
{
    return qobject_cast<const QAbstractSpinBox*>(&object)
        || qobject_cast<const QAbstractSpinBox*>(object.parent());
}

} // namespace

PointedPreview::PointedPreview(PreviewRow& row)
    : m_row(row)
{
    connect(&row, &PreviewRow::switched, this, &PointedPreview::follow);
}

void PointedPreview::watch(QWidget& widget, Asked asked)
{
    m_watched[&widget] = std::move(asked);
    widget.installEventFilter(this);
}

void PointedPreview::setPointedAt(QWidget* widget)
{
    if (m_pointedAt == widget)
        return;
    m_pointedAt = widget;
    hearKeys();
    pointAnew();
}

void PointedPreview::setFocused(QWidget* widget)
{
    if (m_focused == widget)
        return;
    m_focused = widget;
    hearKeys();
    pointAnew();
}

void PointedPreview::pointAtEntry(const std::optional<core::Edit>& edit)
{
    if (!edit && !m_entry)
        return;
    m_entry = edit;
    hearKeys();
    pointAnew();
}

/// While something is pointed at, listens to the keys and the pen wherever their events go. Qt asks
/// the event filter that was installed last first, so keys of number fields are heard here before
/// the window takes them (FieldManners).
void PointedPreview::hearKeys()
{
    if (m_pointedAt || m_focused || m_entry)
        qApp->installEventFilter(this);
    else
        qApp->removeEventFilter(this);
}

bool PointedPreview::eventFilter(QObject* watched, QEvent* event)
{
    if (takesBack(*watched, *event))
        return true;
    if (m_watched.contains(watched))
        look(*static_cast<QWidget*>(watched), *event);
    else if (m_pointedAt && isPenElsewhere(*watched, *event))
        setPointedAt(nullptr);
    return QObject::eventFilter(watched, event);
}

/// @param widget one that is watched
void PointedPreview::look(QWidget& widget, const QEvent& event)
{
    switch (event.type()) {
    case QEvent::Enter:
        setPointedAt(&widget);
        break;
    case QEvent::Leave:
        if (m_pointedAt == &widget)
            setPointedAt(nullptr);
        break;
    case QEvent::FocusIn:
        if (comesByKeyboard(widget, static_cast<const QFocusEvent&>(event)))
            setFocused(&widget);
        break;
    case QEvent::FocusOut:
        if (m_focused == &widget)
            setFocused(nullptr);
        break;
    case QEvent::Hide:
        setPointedAt(nullptr);
        setFocused(nullptr);
        break;
    default:
        break;
    }
}

/// Where a widget takes a pen's own events, as views do, Qt does not tell the widget before that it
/// was left. What a widget does not take goes on to those around it.
bool PointedPreview::isPenElsewhere(QObject& receiver, const QEvent& event) const
{
    if (event.type() == QEvent::TabletLeaveProximity)
        return true;
    const bool isPen = event.type() == QEvent::TabletMove || event.type() == QEvent::TabletPress;
    const auto* widget = isPen ? qobject_cast<const QWidget*>(&receiver) : nullptr;
    return widget && !widget->isAncestorOf(m_pointedAt) && !m_pointedAt->isAncestorOf(widget);
}

/// Qt first asks whether somebody wants such a key, before it becomes a shortcut that would undo a
/// step. A text field takes back what was typed into it first; keys that it leaves go on to the
/// widgets around it. Number fields leave undo to the window.
bool PointedPreview::takesBack(QObject& receiver, QEvent& event)
{
    const bool isAsked = event.type() == QEvent::ShortcutOverride;
    if ((!isAsked && event.type() != QEvent::KeyPress) || !m_row.isPreviewing())
        return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    const bool isEscape = key.key() == Qt::Key_Escape;
    const bool isUndo = key.matches(QKeySequence::Undo);
    const bool isNumber = isOfNumberField(receiver);
    if (!receiver.isWidgetType() || (!isEscape && !isUndo) || (isEscape && isNumber)
        || (!isNumber && qobject_cast<const QLineEdit*>(&receiver)))
        return false;
    if (isEscape && m_entry) {
        if (!isAsked)
            rest();
        return false; // it closes the menu, too
    }
    event.accept();
    if (!isAsked)
        rest();
    return true;
}

void PointedPreview::follow()
{
    if (m_entry)
        return m_row.preview(m_rests ? std::nullopt : m_entry);
    QWidget* const meant = m_pointedAt ? m_pointedAt : m_focused;
    const auto asked = m_rests ? m_watched.end() : m_watched.find(meant);
    m_row.preview(asked == m_watched.end() ? std::nullopt : asked->second());
}

void PointedPreview::rest()
{
    m_rests = true;
    follow();
}

void PointedPreview::pointAnew()
{
    m_rests = false;
    follow();
}

} // namespace ui
