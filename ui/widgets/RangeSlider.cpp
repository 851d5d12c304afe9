// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/RangeSlider.h"

#include "ui/base/Theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double handleRadius = 5.0;
constexpr double margin = handleRadius + 2.0;

} // namespace

RangeSlider::RangeSlider(QWidget* parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void RangeSlider::setBounds(double minimum, double maximum, double leastSpan)
{
    m_minimum = minimum;
    m_maximum = std::max(maximum, minimum + 1e-9);
    m_leastSpan = leastSpan;
    update();
}

void RangeSlider::setValues(double lower, double upper)
{
    m_values[0] = lower;
    m_values[1] = upper;
    update();
}

double RangeSlider::xOf(double value) const
{
    const double part = (value - m_minimum) / (m_maximum - m_minimum);
    return margin + std::clamp(part, 0.0, 1.0) * (width() - 2.0 * margin);
}

double RangeSlider::valueAt(double x) const
{
    const double part = (x - margin) / std::max(width() - 2.0 * margin, 1.0);
    return m_minimum + std::clamp(part, 0.0, 1.0) * (m_maximum - m_minimum);
}

void RangeSlider::moveHandle(int handle, double value)
{
    const double least = handle == 0 ? m_minimum : m_values[0] + m_leastSpan;
    const double most = handle == 0 ? m_values[1] - m_leastSpan : m_maximum;
    if (least > most)
        return;
    value = std::clamp(value, least, most);
    if (value == m_values[handle])
        return;
    m_values[handle] = value;
    update();
    Q_EMIT valuesEdited(m_values[0], m_values[1]);
}

void RangeSlider::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double y = height() / 2.0;
    const double from = xOf(m_values[0]);
    const double to = xOf(m_values[1]);
    painter.setPen(QPen(theme::line, 2.0));
    painter.drawLine(QPointF(margin, y), QPointF(width() - margin, y));
    painter.setPen(QPen(isEnabled() ? theme::accent : theme::faint, 2.0));
    painter.drawLine(QPointF(from, y), QPointF(to, y));
    for (int handle = 0; handle < 2; ++handle) {
        const bool marked = hasFocus() && handle == m_active;
        painter.setPen(marked ? QPen(theme::accent, 2.0) : QPen(theme::panel, 2.0));
        painter.setBrush(isEnabled() ? theme::text : theme::faint);
        painter.drawEllipse(QPointF(handle == 0 ? from : to, y), handleRadius, handleRadius);
    }
}

void RangeSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    const double x = event->position().x();
    const double middle = 0.5 * (xOf(m_values[0]) + xOf(m_values[1]));
    m_active = x < middle ? 0 : 1;
    m_dragging = true;
    moveHandle(m_active, valueAt(x));
    update();
}

void RangeSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (m_dragging)
        moveHandle(m_active, valueAt(event->position().x()));
}

void RangeSlider::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        m_dragging = false;
}

void RangeSlider::wheelEvent(QWheelEvent* event)
{
    event->ignore();
}

void RangeSlider::keyPressEvent(QKeyEvent* event)
{
    const double step =
        std::max(m_leastSpan, 1e-6) * ((event->modifiers() & Qt::ShiftModifier) ? 10.0 : 1.0);
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
        return moveHandle(m_active, m_values[m_active] - step);
    case Qt::Key_Right:
    case Qt::Key_Up:
        return moveHandle(m_active, m_values[m_active] + step);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace ui
