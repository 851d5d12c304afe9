// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/HistogramRangePlot.h"

#include "ui/base/Theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double reach = 6.0; ///< logical pixels within which a handle is caught

} // namespace

HistogramRangePlot::HistogramRangePlot(QWidget* parent)
    : HistogramPlot(parent)
{
    setAccessibleName(tr("Interval on the histogram"));
    setToolTip(tr("Drag the handles or the stretch between them; Ctrl+wheel zooms, a double click "
                  "shows all values"));
}

void HistogramRangePlot::setRange(double lower, double upper)
{
    m_lower = lower;
    m_upper = upper;
    update();
}

void HistogramRangePlot::setMarkers(const std::vector<double>& values)
{
    m_markers = values;
    update();
}

void HistogramRangePlot::setBands(const std::vector<std::pair<double, double>>& bands,
    const std::optional<std::pair<double, double>>& stronger)
{
    m_bands = bands;
    m_strongerBand = stronger;
    update();
}

HistogramRangePlot::Grip HistogramRangePlot::gripAt(double x) const
{
    const double toLower = std::abs(x - xOf(m_lower));
    const double toUpper = std::abs(x - xOf(m_upper));
    if (std::min(toLower, toUpper) <= reach) {
        return toLower < toUpper ? Grip::Lower : Grip::Upper;
    }
    if (x > xOf(m_lower) && x < xOf(m_upper))
        return Grip::Both;
    return Grip::None;
}

void HistogramRangePlot::move(Grip grip, double lower, double upper)
{
    const double minimum = histogram().minimum;
    const double maximum = histogram().maximum;
    if (grip == Grip::Lower) {
        lower = std::clamp(lower, minimum, m_upper);
        upper = m_upper;
    } else if (grip == Grip::Upper) {
        upper = std::clamp(upper, m_lower, maximum);
        lower = m_lower;
    } else {
        const double width = upper - lower;
        lower = std::clamp(lower, minimum, std::max(minimum, maximum - width));
        upper = lower + width;
    }
    if (lower == m_lower && upper == m_upper)
        return;
    setRange(lower, upper);
    Q_EMIT rangeDragged(lower, upper);
}

void HistogramRangePlot::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || histogram().counts.empty())
        return;
    m_grip = gripAt(event->position().x());
    if (m_grip != Grip::None)
        m_lastGrip = m_grip;
    m_pressX = event->position().x();
    m_pressLower = m_lower;
    m_pressUpper = m_upper;
    update();
}

void HistogramRangePlot::mouseMoveEvent(QMouseEvent* event)
{
    const double x = event->position().x();
    if (m_grip == Grip::None) {
        const Grip under = gripAt(x);
        setCursor(under == Grip::None ? Qt::ArrowCursor
                : under == Grip::Both ? Qt::OpenHandCursor
                                      : Qt::SizeHorCursor);
        return;
    }
    // On top of each other: it is the one that can move that way.
    if (m_grip != Grip::Both && m_pressLower == m_pressUpper && m_lower == m_upper && x != m_pressX)
        m_grip = m_lastGrip = x < m_pressX ? Grip::Lower : Grip::Upper;
    const double shift = roundedValueAt(x) - roundedValueAt(m_pressX);
    if (m_grip == Grip::Both)
        move(m_grip, m_pressLower + shift, m_pressUpper + shift);
    else
        move(m_grip, roundedValueAt(x), roundedValueAt(x));
}

void HistogramRangePlot::mouseReleaseEvent(QMouseEvent*)
{
    if (m_grip != Grip::None)
        Q_EMIT released();
    m_grip = Grip::None;
    update();
}

void HistogramRangePlot::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (gripAt(event->position().x()) == Grip::None)
        showAll();
}

void HistogramRangePlot::keyPressEvent(QKeyEvent* event)
{
    if (m_grip != Grip::None && event->key() == Qt::Key_Escape) {
        m_grip = Grip::None;
        setRange(m_pressLower, m_pressUpper);
        Q_EMIT rangeDragged(m_pressLower, m_pressUpper);
        Q_EMIT cancelled();
        return;
    }
    const int direction = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
    if (direction == 0) {
        HistogramPlot::keyPressEvent(event);
        return;
    }
    const double worth = roundedValueAt(1.0 + direction) - roundedValueAt(1.0);
    move(m_lastGrip, m_lower + worth, m_upper + worth);
    Q_EMIT released();
}

void HistogramRangePlot::paintBands(QPainter& painter) const
{
    const QRectF area = plotArea();
    const auto place = [&](const std::pair<double, double>& band) {
        const double left = xOf(band.first);
        return QRectF(QPointF(left, area.top()),
            QPointF(std::max(xOf(band.second), left + 1.0), area.bottom()));
    };
    QColor fill = theme::caution;
    fill.setAlpha(45);
    for (const std::pair<double, double>& band : m_bands) {
        const QRectF at = place(band);
        painter.fillRect(at, fill);
        painter.setPen(QPen(theme::caution, 1.0, Qt::DashLine));
        painter.drawLine(at.topLeft(), at.bottomLeft());
        painter.drawLine(at.topRight(), at.bottomRight());
    }
    if (m_strongerBand)
        painter.fillRect(place(*m_strongerBand), fill);
}

void HistogramRangePlot::paintEvent(QPaintEvent* event)
{
    HistogramPlot::paintEvent(event);
    if (histogram().counts.empty())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = plotArea();
    const double left = xOf(m_lower);
    const double right = xOf(m_upper);
    const QColor colour = isEnabled() ? theme::accent : theme::secondary;
    painter.save();
    painter.setClipRect(QRectF(rect()));
    painter.fillRect(QRectF(QPointF(left, area.top()), QPointF(right, area.bottom())),
        QColor(colour.red(), colour.green(), colour.blue(), 60));
    paintBands(painter);
    for (const double x : {left, right}) {
        painter.setPen(QPen(colour, 2.0));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawRoundedRect(QRectF(x - 3.5, area.center().y() - 8.0, 7.0, 16.0), 3.0, 3.0);
    }
    painter.setPen(QPen(theme::caution, 1.5));
    for (const double marker : m_markers) {
        const double x = xOf(marker);
        painter.drawLine(QPointF(x, area.bottom() - 7.0), QPointF(x, area.bottom()));
    }
    painter.restore();
    if (hasFocus()) {
        painter.setPen(QPen(theme::accent, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), theme::cornerRadius,
            theme::cornerRadius);
    }
}

} // namespace ui
