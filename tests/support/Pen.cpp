// SPDX-License-Identifier: Apache-2.0
#include "tests/support/Pen.h"

#include <QCoreApplication>
#include <QTabletEvent>
#include <QWidget>

namespace test {

Pen::Pen(QWidget& widget, End end)
    : m_widget(widget)
    , m_device(QStringLiteral("test pen"), 11, QInputDevice::DeviceType::Stylus,
          end == End::Tip ? QPointingDevice::PointerType::Pen
                          : QPointingDevice::PointerType::Eraser,
          QInputDevice::Capability::Position | QInputDevice::Capability::Pressure
              | QInputDevice::Capability::Hover,
          1, 3)
{
}

void Pen::post(int type, const QPointF& at, double pressure, quint64 milliseconds,
    Qt::MouseButton button, Qt::MouseButtons buttons)
{
    auto* event = new QTabletEvent(QEvent::Type(type), &m_device, at, m_widget.mapToGlobal(at),
        pressure, 0.0f, 0.0f, 0.0f, 0.0, 0.0f, Qt::NoModifier, button, buttons);
    event->setTimestamp(milliseconds);
    QCoreApplication::postEvent(&m_widget, event);
    QCoreApplication::sendPostedEvents(&m_widget);
}

void Pen::hover(const QPointF& at, quint64 milliseconds)
{
    post(QEvent::TabletMove, at, 0.0, milliseconds, Qt::NoButton, Qt::NoButton);
}

void Pen::press(const QPointF& at, double pressure, quint64 milliseconds)
{
    post(QEvent::TabletPress, at, pressure, milliseconds, Qt::LeftButton, Qt::LeftButton);
}

void Pen::move(const QPointF& at, double pressure, quint64 milliseconds)
{
    post(QEvent::TabletMove, at, pressure, milliseconds, Qt::NoButton, Qt::LeftButton);
}

void Pen::release(const QPointF& at, quint64 milliseconds)
{
    post(QEvent::TabletRelease, at, 0.0, milliseconds, Qt::LeftButton, Qt::NoButton);
}

} // namespace test
