// SPDX-License-Identifier: Apache-2.0
#include "ui/input/HeldKey.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>

namespace ui {

HeldKey::HeldKey(QAction& action)
    : QObject(&action)
    , m_action(action)
    , m_key(action.shortcut()[0].key())
{
    m_short.setSingleShot(true);
    m_short.setInterval(heldMilliseconds);
    // A key that is held would switch on and off.
    action.setAutoRepeat(false);
    connect(&action, &QAction::triggered, this, [this] {
        // From a menu it stays switched.
        m_switched = m_pressed && !m_switched;
        if (m_switched)
            m_short.start();
    });
    qApp->installEventFilter(this);
}

bool HeldKey::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride: // before the action hears of it
    case QEvent::KeyPress: {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == m_key && !key->isAutoRepeat())
            m_pressed = true;
        break;
    }
    case QEvent::KeyRelease: {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == m_key && !key->isAutoRepeat())
            letGo(!m_short.isActive());
        break;
    }
    case QEvent::WindowDeactivate:
    case QEvent::ApplicationDeactivate:
        letGo(true);
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

void HeldKey::letGo(bool wasHeld)
{
    m_pressed = false;
    m_short.stop();
    const bool switchesBack = m_switched && wasHeld;
    m_switched = false;
    if (switchesBack && m_action.isEnabled())
        m_action.trigger();
}

} // namespace ui
