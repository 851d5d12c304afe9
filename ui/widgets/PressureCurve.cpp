// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/PressureCurve.h"

#include "ui/base/Theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

QPainterPath curve(const QRectF& plot, int exponent)
{
    QPainterPath path(plot.bottomLeft());
    constexpr int pieces = 48;
    for (int i = 1; i <= pieces; ++i) {
        const double pressure = double(i) / pieces;
        path.lineTo(plot.left() + pressure * plot.width(),
            plot.bottom() - std::pow(pressure, exponent) * plot.height());
    }
    return path;
}

} // namespace

PressureCurve::PressureCurve(QWidget* parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Pressure curve"));
    setMinimumSize(sizeHint());
}

void PressureCurve::setExponent(int exponent)
{
    m_exponent = std::clamp(exponent, 1, greatestExponent);
    update();
}

QRectF PressureCurve::plot() const
{
    return QRectF(rect()).adjusted(28.0, 10.0, -10.0, -24.0);
}

void PressureCurve::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = plot();
    painter.setPen(QPen(theme::line, 1.0));
    painter.drawRect(area);
    for (int exponent = 1; exponent <= greatestExponent; ++exponent) {
        if (exponent == m_exponent)
            continue;
        painter.setPen(QPen(theme::line, 1.6));
        painter.drawPath(curve(area, exponent));
    }
    painter.setPen(QPen(theme::accent, 2.0));
    painter.drawPath(curve(area, m_exponent));
    // What half the pressure cuts, since that is how a hand thinks.
    const double half = std::pow(0.5, m_exponent);
    const QPointF at(area.center().x(), area.bottom() - half * area.height());
    painter.setPen(QPen(theme::secondary, 1.0, Qt::DashLine));
    painter.drawLine(QPointF(at.x(), area.bottom()), at);
    painter.drawLine(QPointF(area.left(), at.y()), at);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::accent);
    painter.drawEllipse(at, 3.5, 3.5);
    painter.setFont(theme::smallFont());
    painter.setPen(theme::secondary);
    const auto percent = [](double share) {
        return QString::number(std::lround(100.0 * share)) + QLatin1Char('%');
    };
    painter.drawText(QRectF(0.0, at.y() - 8.0, area.left() - 4.0, 16.0),
        Qt::AlignRight | Qt::AlignVCenter, percent(half));
    painter.drawText(QRectF(area.left(), area.bottom() + 4.0, area.width(), 16.0),
        Qt::AlignHCenter | Qt::AlignTop, tr("half the pressure"));
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(theme::accent, 1.0));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void PressureCurve::choose(const QPointF& position)
{
    const QRectF area = plot();
    const double pressure = std::clamp((position.x() - area.left()) / area.width(), 0.05, 0.95);
    const double share = (area.bottom() - position.y()) / area.height();
    int nearest = 1;
    for (int exponent = 2; exponent <= greatestExponent; ++exponent) {
        if (std::abs(std::pow(pressure, exponent) - share)
            < std::abs(std::pow(pressure, nearest) - share))
            nearest = exponent;
    }
    take(nearest);
}

void PressureCurve::take(int exponent)
{
    const int wanted = std::clamp(exponent, 1, greatestExponent);
    if (wanted == m_exponent)
        return;
    setExponent(wanted);
    Q_EMIT exponentChosen(wanted);
}

void PressureCurve::mousePressEvent(QMouseEvent* event)
{
    choose(event->position());
}

void PressureCurve::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton))
        choose(event->position());
}

void PressureCurve::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Up)
        take(m_exponent - 1);
    else if (event->key() == Qt::Key_Right || event->key() == Qt::Key_Down)
        take(m_exponent + 1);
    else
        QWidget::keyPressEvent(event);
}

} // namespace ui
