// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/HistogramPlot.h"

#include "ui/base/Theme.h"
#include "ui/widgets/MarkedCurve.h"

#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace ui {

HistogramPlot::HistogramPlot(QWidget* parent)
    : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
}

void HistogramPlot::setHistogram(const core::Histogram& histogram)
{
    m_histogram = histogram;
    showAll();
}

void HistogramPlot::showAll()
{
    m_from = m_histogram.minimum;
    m_to = m_histogram.maximum > m_histogram.minimum ? m_histogram.maximum : m_from + 1.0;
    update();
}

void HistogramPlot::showValues(double from, double to)
{
    const double smallest = (m_histogram.maximum - m_histogram.minimum) / 1000.0;
    if (!(to - from > smallest) || m_histogram.counts.empty())
        return;
    m_from = std::max(from, m_histogram.minimum);
    m_to = std::min(to, m_histogram.maximum);
    if (m_to - m_from < smallest)
        showAll();
    update();
}

QRectF HistogramPlot::plotArea() const
{
    return QRectF(rect()).adjusted(6.0, 2.0, -6.0, -2.0);
}

double HistogramPlot::xOf(double value) const
{
    const QRectF area = plotArea();
    return area.left() + (value - m_from) / (m_to - m_from) * area.width();
}

double HistogramPlot::valueAt(double x) const
{
    const QRectF area = plotArea();
    return m_from + (x - area.left()) / area.width() * (m_to - m_from);
}

double HistogramPlot::roundedValueAt(double x) const
{
    const double perPixel = (m_to - m_from) / std::max(1.0, plotArea().width());
    const double step = std::pow(10.0, std::floor(std::log10(perPixel)));
    return std::round(valueAt(x) / step) * step;
}

void HistogramPlot::wheelEvent(QWheelEvent* event)
{
    // Whoever scrolls a panel would otherwise stop where the plot comes under the cursor.
    if (!hasFocus() && !event->modifiers().testFlag(Qt::ControlModifier)) {
        event->ignore();
        return;
    }
    const double pivot = valueAt(event->position().x());
    const double factor = std::pow(0.8, event->angleDelta().y() / 120.0);
    showValues(pivot + (m_from - pivot) * factor, pivot + (m_to - pivot) * factor);
    event->accept();
}

void HistogramPlot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paintCurveGround(painter, size());
    if (m_histogram.counts.empty())
        return;

    const QRectF area = plotArea();
    const double perBin =
        (m_histogram.maximum - m_histogram.minimum) / double(m_histogram.counts.size());
    const std::uint32_t peak =
        *std::max_element(m_histogram.counts.begin(), m_histogram.counts.end());
    const double top = std::log1p(double(peak));
    // One column per pixel: the mean of the bins under it, so that narrow bins do not flicker.
    QPainterPath path;
    path.moveTo(area.left(), area.bottom());
    for (double x = area.left(); x <= area.right(); x += 1.0) {
        const double from = (valueAt(x - 0.5) - m_histogram.minimum) / perBin;
        const double to = (valueAt(x + 0.5) - m_histogram.minimum) / perBin;
        const auto last = std::ptrdiff_t(m_histogram.counts.size()) - 1;
        const auto first = std::clamp(std::ptrdiff_t(std::floor(from)), std::ptrdiff_t(0), last);
        const auto end = std::clamp(std::ptrdiff_t(std::ceil(to)), first + 1, last + 1);
        double sum = 0.0;
        for (auto bin = first; bin < end; ++bin)
            sum += double(m_histogram.counts[std::size_t(bin)]);
        const double height = top > 0.0 ? std::log1p(sum / double(end - first)) / top : 0.0;
        path.lineTo(x, area.bottom() - height * (area.height() - 4.0));
    }
    path.lineTo(area.right(), area.bottom());
    painter.setClipRect(area);
    painter.setPen(QPen(theme::secondary, 1.0));
    painter.setBrush(
        QColor(theme::secondary.red(), theme::secondary.green(), theme::secondary.blue(), 60));
    painter.drawPath(path);
}

} // namespace ui
