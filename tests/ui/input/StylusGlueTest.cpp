// SPDX-License-Identifier: Apache-2.0
#include "ui/input/StylusGlue.h"
#include "tests/support/program/TestProgram.h"

#include <QMouseEvent>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QtTest>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace stylusGlueTest {

using ui::PointerReading;
using ui::StylusGlue;

class StylusGlueTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QPointingDevice> device(QInputDevice::DeviceType type,
        QPointingDevice::PointerType pointer, QInputDevice::Capabilities more = {})
    {
        return std::make_unique<QPointingDevice>(QStringLiteral("test"), 7, type, pointer,
            QInputDevice::Capability::Position | QInputDevice::Capability::Pressure | more, 1, 3);
    }
    std::unique_ptr<QPointingDevice> m_pen =
        device(QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen);
    std::unique_ptr<QPointingDevice> m_artPen = device(QInputDevice::DeviceType::Stylus,
        QPointingDevice::PointerType::Pen, QInputDevice::Capability::Rotation);
    std::unique_ptr<QPointingDevice> m_eraser =
        device(QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Eraser);
    std::unique_ptr<QPointingDevice> m_mouse =
        device(QInputDevice::DeviceType::Mouse, QPointingDevice::PointerType::Generic);

    std::vector<std::unique_ptr<QEvent>> m_events; ///< events cannot be moved

    QTabletEvent& tablet(QEvent::Type type, QPointF at, double pressure, quint64 milliseconds,
        Qt::MouseButton button, Qt::MouseButtons buttons, const QPointingDevice* source)
    {
        auto event = std::make_unique<QTabletEvent>(type, source, at, at + QPointF(100, 200),
            pressure, 0, 0, 0, 0, 0, Qt::ShiftModifier, button, buttons);
        event->setTimestamp(milliseconds);
        QTabletEvent& made = *event;
        m_events.push_back(std::move(event));
        return made;
    }
    QMouseEvent& mouse(QEvent::Type type, QPointF at, Qt::MouseButton button,
        Qt::MouseButtons buttons, const QPointingDevice* source, quint64 milliseconds = 0)
    {
        auto event = std::make_unique<QMouseEvent>(
            type, at, at, at, button, buttons, Qt::ControlModifier, source);
        event->setTimestamp(milliseconds);
        QMouseEvent& made = *event;
        m_events.push_back(std::move(event));
        return made;
    }

private Q_SLOTS:
    void readsThePen()
    {
        StylusGlue glue;
        auto& press = tablet(QEvent::TabletPress, {10.25, 20.5}, 0.375, 12345, Qt::LeftButton,
            Qt::LeftButton, m_pen.get());
        const auto reading = glue.read(press);
        QVERIFY(reading);
        QVERIFY(glue.penDown());
        QCOMPARE(reading->phase, PointerReading::Phase::Press);
        QCOMPARE(reading->button, Qt::LeftButton);
        QVERIFY(reading->pen);
        QCOMPARE(reading->sample.position, QPointF(10.25, 20.5));
        QCOMPARE(reading->sample.pressure, 0.375);
        QCOMPARE(reading->sample.timeSeconds, 12.345);
        QCOMPARE(reading->sample.modifiers, Qt::ShiftModifier);
        QVERIFY(!reading->sample.eraserEnd);

        auto& move = tablet(
            QEvent::TabletMove, {11, 21}, 1.5, 12353, Qt::NoButton, Qt::LeftButton, m_pen.get());
        const auto moved = glue.read(move);
        QVERIFY(moved);
        QCOMPARE(moved->phase, PointerReading::Phase::Move);
        QVERIFY(!moved->hovering());
        QCOMPARE(moved->sample.pressure, 1.0);

        auto& release = tablet(
            QEvent::TabletRelease, {11, 21}, 0, 12360, Qt::LeftButton, Qt::NoButton, m_pen.get());
        const auto released = glue.read(release);
        QVERIFY(released);
        QCOMPARE(released->phase, PointerReading::Phase::Release);
        QVERIFY(!glue.penDown());
    }

    void knowsTheEraserEnd()
    {
        StylusGlue glue;
        auto& press = tablet(
            QEvent::TabletPress, {1, 1}, 0.5, 0, Qt::LeftButton, Qt::LeftButton, m_eraser.get());
        QVERIFY(glue.read(press)->sample.eraserEnd);
    }

    void knowsTiltAndRotation()
    {
        StylusGlue glue;
        const auto read = [&glue](const QPointingDevice& pen, double rotation) {
            QTabletEvent press(QEvent::TabletPress, &pen, {1, 1}, {1, 1}, 0.5, 20, -35, 0, rotation,
                0, Qt::NoModifier, Qt::LeftButton, Qt::LeftButton);
            return glue.read(press)->sample;
        };
        QCOMPARE(read(*m_artPen, 90).tiltDegrees, QPointF(20, -35));
        QCOMPARE(read(*m_artPen, 90).rotationDegrees.value_or(0.0), 90.0);
        QCOMPARE(read(*m_artPen, 0).rotationDegrees.value_or(1.0), 0.0);
        QVERIFY(!read(*m_artPen, std::nan("")).rotationDegrees);
        // A pen that cannot tell says 0, which means nothing.
        QVERIFY(!read(*m_pen, 0).rotationDegrees);
    }

    void noNumberIsNoPressure()
    {
        StylusGlue glue;
        for (const double pressure : {std::nan(""), double(INFINITY), -1.0}) {
            auto& move = tablet(
                QEvent::TabletMove, {1, 1}, pressure, 0, Qt::NoButton, Qt::LeftButton, m_pen.get());
            QCOMPARE(glue.read(move)->sample.pressure, 0.0);
        }
    }

    void hoverHasNoPressure()
    {
        StylusGlue glue;
        auto& move =
            tablet(QEvent::TabletMove, {5, 5}, 0.0, 1, Qt::NoButton, Qt::NoButton, m_pen.get());
        QVERIFY(glue.read(move)->hovering());
        auto& mouseMove =
            mouse(QEvent::MouseMove, {5, 5}, Qt::NoButton, Qt::NoButton, m_mouse.get());
        const auto reading = glue.read(mouseMove);
        QVERIFY(reading->hovering());
        QCOMPARE(reading->sample.pressure, 0.0);
    }

    void readsTheMouse()
    {
        StylusGlue glue;
        auto& press = mouse(QEvent::MouseButtonPress, {3, 4}, Qt::RightButton, Qt::RightButton,
            m_mouse.get(), 2500);
        const auto reading = glue.read(press);
        QVERIFY(reading);
        QVERIFY(!reading->pen);
        QCOMPARE(reading->button, Qt::RightButton);
        QCOMPARE(reading->sample.pressure, 1.0);
        QCOMPARE(reading->sample.timeSeconds, 2.5);
        QCOMPARE(reading->sample.modifiers, Qt::ControlModifier);

        // Two quick dabs with a tool are two strokes, so a double click is a press as well.
        auto& twice = mouse(
            QEvent::MouseButtonDblClick, {3, 4}, Qt::LeftButton, Qt::LeftButton, m_mouse.get());
        QVERIFY(glue.read(twice)->doubleClick);
        QCOMPARE(glue.read(twice)->phase, PointerReading::Phase::Press);
    }

    void swallowsEchoesOfThePen()
    {
        StylusGlue glue;
        // What Qt makes of an unaccepted pen event names the pen as its device.
        auto& echo =
            mouse(QEvent::MouseButtonPress, {1, 1}, Qt::LeftButton, Qt::LeftButton, m_pen.get());
        echo.ignore();
        QVERIFY(!glue.read(echo));
        QVERIFY(echo.isAccepted());

        // The server's core pointer follows the pen; it counts again once the tip is up.
        auto& press = tablet(
            QEvent::TabletPress, {1, 1}, 0.5, 0, Qt::LeftButton, Qt::LeftButton, m_pen.get());
        QVERIFY(glue.read(press));
        auto& core = mouse(QEvent::MouseMove, {2, 2}, Qt::NoButton, Qt::LeftButton, m_mouse.get());
        QVERIFY(!glue.read(core));
        auto& release =
            tablet(QEvent::TabletRelease, {2, 2}, 0, 9, Qt::LeftButton, Qt::NoButton, m_pen.get());
        QVERIFY(glue.read(release));
        QVERIFY(glue.read(core));
    }

    void leavesOtherEventsAlone()
    {
        StylusGlue glue;
        QEvent event(QEvent::Enter);
        QVERIFY(!glue.read(event));
    }
};

BURIN_TEST(StylusGlueTest)

} // namespace stylusGlueTest

#include "StylusGlueTest.moc"
