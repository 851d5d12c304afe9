// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/PointerCanvas.h"

#include "ui/base/Theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPointingDevice>
#include <QTabletEvent>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr std::size_t dabsKept = 4000;
constexpr double widestPixels = 14.0;

QString deviceText(const QPointingDevice* device)
{
    if (!device)
        return QObject::tr("unknown device");
    QString type;
    switch (device->type()) {
    case QInputDevice::DeviceType::Stylus:
        type = QObject::tr("Pen");
        break;
    case QInputDevice::DeviceType::Airbrush:
        type = QObject::tr("Airbrush");
        break;
    case QInputDevice::DeviceType::Puck:
        type = QObject::tr("Puck");
        break;
    case QInputDevice::DeviceType::TouchPad:
        type = QObject::tr("Touch pad");
        break;
    case QInputDevice::DeviceType::Mouse:
        type = QObject::tr("Mouse");
        break;
    default:
        type = QObject::tr("Device");
        break;
    }
    // Names that come from an X server may end in what is no character.
    QString name;
    for (const QChar letter : device->name()) {
        if (letter.isPrint())
            name += letter;
    }
    if (!name.isEmpty())
        type += QStringLiteral(" '%1'").arg(name);
    if (device->pointerType() == QPointingDevice::PointerType::Eraser)
        type += QObject::tr(", eraser end");
    return type;
}

QString kindText(QEvent::Type type, Qt::MouseButtons buttons)
{
    switch (type) {
    case QEvent::TabletPress:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        return QStringLiteral("press");
    case QEvent::TabletRelease:
    case QEvent::MouseButtonRelease:
        return QStringLiteral("release");
    default:
        return buttons == Qt::NoButton ? QStringLiteral("hover") : QStringLiteral("move");
    }
}

RawPointerEvent raw(const QSinglePointEvent& event)
{
    RawPointerEvent result;
    result.kind = kindText(event.type(), event.buttons());
    result.device = deviceText(event.pointingDevice());
    result.eraser = event.pointingDevice()
        && event.pointingDevice()->pointerType() == QPointingDevice::PointerType::Eraser;
    result.position = event.position();
    result.buttons = event.buttons();
    result.modifiers = event.modifiers();
    result.milliseconds = event.timestamp();
    return result;
}

} // namespace

PointerCanvas::PointerCanvas(QWidget* parent)
    : QWidget(parent)
{
    setMouseTracking(true);
    setTabletTracking(true);
    setCursor(Qt::CrossCursor);
    setAttribute(Qt::WA_OpaquePaintEvent);
}

void PointerCanvas::clear()
{
    m_dabs.clear();
    m_last = {};
    update();
}

bool PointerCanvas::event(QEvent* event)
{
    switch (event->type()) {
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease: {
        const auto& tablet = static_cast<const QTabletEvent&>(*event);
        RawPointerEvent reading = raw(tablet);
        reading.pen = true;
        reading.pressure = tablet.pressure();
        reading.tiltDegrees = {tablet.xTilt(), tablet.yTilt()};
        reading.rotationDegrees = tablet.rotation();
        reading.wheel = tablet.tangentialPressure();
        take(reading);
        event->accept();
        return true;
    }
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease: {
        const auto& mouse = static_cast<const QMouseEvent&>(*event);
        RawPointerEvent reading = raw(mouse);
        reading.pressure = mouse.buttons() == Qt::NoButton ? 0.0 : 1.0;
        take(reading);
        event->accept();
        return true;
    }
    default:
        return QWidget::event(event);
    }
}

void PointerCanvas::take(const RawPointerEvent& event)
{
    const bool down = event.buttons != Qt::NoButton;
    if (down) {
        const double pressure =
            std::isfinite(event.pressure) ? std::clamp(event.pressure, 0.0, 1.0) : 0.0;
        if (m_dabs.size() >= dabsKept)
            m_dabs.erase(m_dabs.begin(), m_dabs.begin() + dabsKept / 4);
        m_dabs.push_back({m_down ? m_last.position : event.position, event.position, pressure,
            event.pen, event.eraser});
    }
    m_down = down;
    m_last = event;
    update();
    Q_EMIT arrived(event);
}

void PointerCanvas::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme::picture);
    painter.setPen(QPen(theme::line, 1.0));
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    for (const Dab& dab : m_dabs) {
        const QColor colour = dab.eraser ? theme::caution : dab.pen ? theme::accent : theme::text;
        painter.setPen(
            QPen(colour, std::max(1.0, dab.pressure * widestPixels), Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(dab.from, dab.to);
    }
    if (m_dabs.empty() && m_last.kind.isEmpty()) {
        painter.setPen(theme::secondary);
        painter.drawText(rect(), Qt::AlignCenter,
            tr("Draw here with the pen or the mouse. It changes nothing."));
    }
    // Which way the pen leans.
    if (m_last.pen && !m_last.tiltDegrees.isNull()) {
        painter.setPen(QPen(theme::caution, 1.6));
        painter.drawLine(m_last.position, m_last.position + m_last.tiltDegrees);
    }
}

} // namespace ui
