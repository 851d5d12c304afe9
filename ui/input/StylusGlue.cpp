// SPDX-License-Identifier: Apache-2.0
#include "ui/input/StylusGlue.h"

#include <QMouseEvent>
#include <QPointingDevice>
#include <QTabletEvent>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

PointerReading basicReading(const QSinglePointEvent& event)
{
    PointerReading reading;
    reading.button = event.button();
    reading.buttons = event.buttons();
    reading.sample.position = event.position();
    reading.sample.timeSeconds = double(event.timestamp()) / 1000.0;
    reading.sample.modifiers = event.modifiers();
    return reading;
}

bool isPen(const QPointingDevice* device)
{
    if (!device)
        return false;
    const auto type = device->type();
    return type == QInputDevice::DeviceType::Stylus || type == QInputDevice::DeviceType::Airbrush
        || type == QInputDevice::DeviceType::Puck;
}

std::optional<PointerReading> readPen(const QTabletEvent& event, bool& penDown)
{
    PointerReading reading = basicReading(event);
    reading.pen = true;
    reading.sample.isPen = true;
    // A driver that knows no pressure says NaN; nothing is pressed then.
    reading.sample.pressure =
        std::isfinite(event.pressure()) ? std::clamp(event.pressure(), 0.0, 1.0) : 0.0;
    reading.sample.tiltDegrees = {event.xTilt(), event.yTilt()};
    // One that cannot turn says 0.
    const QPointingDevice* device = event.pointingDevice();
    if (device && device->hasCapability(QInputDevice::Capability::Rotation)
        && std::isfinite(event.rotation()))
        reading.sample.rotationDegrees = event.rotation();
    reading.sample.eraserEnd = event.pointerType() == QPointingDevice::PointerType::Eraser;
    switch (event.type()) {
    case QEvent::TabletPress:
        reading.phase = PointerReading::Phase::Press;
        penDown = true;
        break;
    case QEvent::TabletMove:
        reading.phase = PointerReading::Phase::Move;
        break;
    default:
        reading.phase = PointerReading::Phase::Release;
        penDown = event.buttons() != Qt::NoButton;
        break;
    }
    return reading;
}

PointerReading readMouse(const QMouseEvent& event)
{
    PointerReading reading = basicReading(event);
    reading.doubleClick = event.type() == QEvent::MouseButtonDblClick;
    if (event.type() == QEvent::MouseMove)
        reading.phase = PointerReading::Phase::Move;
    else if (event.type() == QEvent::MouseButtonRelease)
        reading.phase = PointerReading::Phase::Release;
    else
        reading.phase = PointerReading::Phase::Press;
    reading.sample.pressure = reading.buttons == Qt::NoButton ? 0.0 : 1.0;
    return reading;
}

} // namespace

std::optional<PointerReading> StylusGlue::read(QEvent& event)
{
    switch (event.type()) {
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
        return readPen(static_cast<const QTabletEvent&>(event), m_penDown);
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease: {
        const auto& mouse = static_cast<const QMouseEvent&>(event);
        // X11 servers move the core pointer along with the pen, so while the tip is down any mouse
        // event is its echo, whatever device it names.
        if (m_penDown || isPen(mouse.pointingDevice())) {
            event.accept();
            return std::nullopt;
        }
        return readMouse(mouse);
    }
    default:
        return std::nullopt;
    }
}

} // namespace ui
