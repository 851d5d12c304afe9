// SPDX-License-Identifier: Apache-2.0
#include "tests/support/Pen.h"

#include <QCoreApplication>
#include <QTabletEvent>
#include <QWidget>

namespace test {

namespace {

QInputDevice::Capabilities capabilities(Pen::Turns turns)
{
    using Capability = QInputDevice::Capability;
    const QInputDevice::Capabilities all = Capability::Position | Capability::Pressure
        | Capability::Hover | Capability::XTilt | Capability::YTilt;
    return turns == Pen::Turns::Yes ? all | Capability::Rotation : all;
}

} // namespace

Pen::Pen(QWidget& widget, End end, Turns turns)
    : m_widget(widget)
    , m_device(QStringLiteral("test pen"), 11, QInputDevice::DeviceType::Stylus,
          end == End::Tip ? QPointingDevice::PointerType::Pen
                          : QPointingDevice::PointerType::Eraser,
          capabilities(turns), 1, 3)
{
}

void Pen::hold(const QPointF& tiltDegrees, double rotationDegrees)
{
    m_tiltDegrees = tiltDegrees;
    m_rotationDegrees = rotationDegrees;
}

void Pen::post(int type, const QPointF& at, double pressure, quint64 milliseconds,
    Qt::MouseButton button, Qt::MouseButtons buttons)
{
    auto* event = new QTabletEvent(QEvent::Type(type), &m_device, at, m_widget.mapToGlobal(at),
        pressure, float(m_tiltDegrees.x()), float(m_tiltDegrees.y()), 0.0f, m_rotationDegrees, 0.0f,
        Qt::NoModifier, button, buttons);
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
