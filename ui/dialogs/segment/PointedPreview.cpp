// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/PointedPreview.h"

#include "ui/dialogs/segment/PreviewRow.h"

#include <QAbstractSpinBox>
#include <QFocusEvent>
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

bool PointedPreview::eventFilter(QObject* watched, QEvent* event)
{
    QObject* const pointedAt = m_pointedAt;
    QObject* const focused = m_focused;
    switch (event->type()) {
    case QEvent::Enter:
        m_pointedAt = watched;
        break;
    case QEvent::Leave:
        if (m_pointedAt == watched)
            m_pointedAt = nullptr;
        break;
    case QEvent::FocusIn:
        if (comesByKeyboard(*watched, static_cast<const QFocusEvent&>(*event)))
            m_focused = watched;
        break;
    case QEvent::FocusOut:
        if (m_focused == watched)
            m_focused = nullptr;
        break;
    case QEvent::Hide:
        m_pointedAt = nullptr;
        m_focused = nullptr;
        break;
    default:
        break;
    }
    if (m_pointedAt != pointedAt || m_focused != focused)
        pointAnew();
    return QObject::eventFilter(watched, event);
}

void PointedPreview::follow()
{
    QObject* const meant = m_pointedAt ? m_pointedAt : m_focused;
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
