// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>
#include <QPointingDevice>

#include <memory>

class QWidget;

namespace test {

/// A tablet pen in the hand of a test: posts QTabletEvents to a widget, as the window system would,
/// with the times it is told, and lets them be handled.
class Pen {
public:
    enum class End { Tip, Eraser };
    enum class Turns { No, Yes }; ///< whether it tells its rotation
    explicit Pen(QWidget& widget, End end = End::Tip, Turns turns = Turns::No);

    /// From now on. @param tilt degrees from upright, right and towards the user
    void hold(const QPointF& tiltDegrees, double rotationDegrees = 0.0);

    void hover(const QPointF& at, quint64 milliseconds);
    void press(const QPointF& at, double pressure, quint64 milliseconds);
    void move(const QPointF& at, double pressure, quint64 milliseconds);
    void release(const QPointF& at, quint64 milliseconds);

private:
    void post(int type, const QPointF& at, double pressure, quint64 milliseconds,
        Qt::MouseButton button, Qt::MouseButtons buttons);

    QWidget& m_widget;
    QPointingDevice m_device;
    QPointF m_tiltDegrees;
    double m_rotationDegrees = 0.0;
};

} // namespace test
