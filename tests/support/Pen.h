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
    explicit Pen(QWidget& widget, End end = End::Tip);

    void hover(const QPointF& at, quint64 milliseconds);
    void press(const QPointF& at, double pressure, quint64 milliseconds);
    void move(const QPointF& at, double pressure, quint64 milliseconds);
    void release(const QPointF& at, quint64 milliseconds);

private:
    void post(int type, const QPointF& at, double pressure, quint64 milliseconds,
        Qt::MouseButton button, Qt::MouseButtons buttons);

    QWidget& m_widget;
    QPointingDevice m_device;
};

} // namespace test
