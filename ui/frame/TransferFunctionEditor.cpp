// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/TransferFunctionEditor.h"

#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"

#include <QColorDialog>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double reach = 8.0; ///< logical pixels within which a point is caught

} // namespace

TransferFunctionEditor::TransferFunctionEditor(QWidget* parent)
    : HistogramPlot(parent)
{
    setAccessibleName(tr("Colour and opacity over values"));
    setFixedHeight(84);
    setToolTip(tr("Drag points · double click adds one, or chooses a point's colour · Delete "
                  "removes · Ctrl+wheel zooms"));
}

void TransferFunctionEditor::setUnit(const QString& unit)
{
    m_unit = unit;
}

void TransferFunctionEditor::setFunction(const gpu::TransferFunction& function)
{
    if (function == m_function)
        return;
    m_function = function;
    if (!m_dragging)
        m_chosen.reset();
    update();
}

QPointF TransferFunctionEditor::positionOf(const gpu::TransferFunction::Point& point) const
{
    const QRectF area = plotArea().adjusted(0.0, 6.0, 0.0, -6.0);
    return {xOf(point.value),
        area.bottom() - std::sqrt(std::clamp(point.opacity, 0.0, 1.0)) * area.height()};
}

double TransferFunctionEditor::opacityAt(double y) const
{
    const QRectF area = plotArea().adjusted(0.0, 6.0, 0.0, -6.0);
    const double height = std::clamp((area.bottom() - y) / area.height(), 0.0, 1.0);
    return std::round(height * height * 1000.0) / 1000.0;
}

std::optional<std::size_t> TransferFunctionEditor::pointAt(const QPointF& position) const
{
    std::optional<std::size_t> nearest;
    double best = reach;
    for (std::size_t i = 0; i < m_function.points.size(); ++i) {
        const QPointF offset = positionOf(m_function.points[i]) - position;
        const double distance = std::hypot(offset.x(), offset.y());
        if (distance <= best) {
            best = distance;
            nearest = i;
        }
    }
    return nearest;
}

void TransferFunctionEditor::notifyEdited()
{
    update();
    Q_EMIT functionEdited(m_function);
}

void TransferFunctionEditor::movePoint(std::size_t point, double value, double opacity)
{
    auto& points = m_function.points;
    const double minimum = point > 0 ? points[point - 1].value : histogram().minimum;
    const double maximum =
        point + 1 < points.size() ? points[point + 1].value : histogram().maximum;
    // A preset may reach beyond the volume's values; such points keep their place.
    points[point].value = minimum <= maximum ? std::clamp(value, minimum, maximum) : value;
    points[point].opacity = opacity;
    notifyEdited();
}

void TransferFunctionEditor::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_chosen = pointAt(event->position());
    m_dragging = m_chosen.has_value();
    update();
}

void TransferFunctionEditor::mouseMoveEvent(QMouseEvent* event)
{
    if (m_dragging && m_chosen) {
        movePoint(
            *m_chosen, roundedValueAt(event->position().x()), opacityAt(event->position().y()));
        return;
    }
    setCursor(pointAt(event->position()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void TransferFunctionEditor::mouseReleaseEvent(QMouseEvent*)
{
    m_dragging = false;
}

void TransferFunctionEditor::mouseDoubleClickEvent(QMouseEvent* event)
{
    m_dragging = false;
    if (histogram().counts.empty())
        return;
    if (const auto point = pointAt(event->position())) {
        const QColor picked = QColorDialog::getColor(
            QColor(m_function.points[*point].rgb), window(), tr("Colour at this value"));
        if (picked.isValid()) {
            m_function.points[*point].rgb = picked.rgb() & 0xFFFFFFu;
            notifyEdited();
        }
        return;
    }
    gpu::TransferFunction::Point added;
    added.value = roundedValueAt(event->position().x());
    added.opacity = opacityAt(event->position().y());
    auto& points = m_function.points;
    const auto place = std::lower_bound(points.begin(), points.end(), added.value,
        [](const gpu::TransferFunction::Point& p, double value) { return p.value < value; });
    if (place != points.end())
        added.rgb = place->rgb;
    else if (!points.empty())
        added.rgb = points.back().rgb;
    m_chosen = std::size_t(place - points.begin());
    points.insert(place, added);
    notifyEdited();
}

void TransferFunctionEditor::keyPressEvent(QKeyEvent* event)
{
    const bool removes = event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace;
    if (!removes || !m_chosen || m_function.points.size() <= 2) {
        HistogramPlot::keyPressEvent(event);
        return;
    }
    m_function.points.erase(m_function.points.begin() + std::ptrdiff_t(*m_chosen));
    m_chosen.reset();
    notifyEdited();
}

void TransferFunctionEditor::paintEvent(QPaintEvent* event)
{
    HistogramPlot::paintEvent(event);
    const auto& points = m_function.points;
    if (histogram().counts.empty() || points.empty())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(rect());
    QPolygonF line;
    line.push_back({plotArea().left(), positionOf(points.front()).y()});
    for (const auto& point : points)
        line.push_back(positionOf(point));
    line.push_back({plotArea().right(), positionOf(points.back()).y()});
    painter.setPen(QPen(theme::caution, 1.6));
    painter.drawPolyline(line);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool chosen = m_chosen == i;
        painter.setPen(QPen(chosen ? theme::accent : theme::caution, chosen ? 2.0 : 1.2));
        painter.setBrush(QColor(points[i].rgb));
        painter.drawEllipse(positionOf(points[i]), 4.5, 4.5);
    }
    if (!m_chosen)
        return;
    const auto& point = points[*m_chosen];
    const QString value = digitsText(point.value, 6);
    painter.setFont(theme::smallFont());
    painter.setPen(theme::text);
    painter.drawText(rect().adjusted(8, 3, -8, -3), Qt::AlignTop | Qt::AlignRight,
        tr("%1 %2 · %3 per mm").arg(value, m_unit, numberText(point.opacity, 3)));
}

} // namespace ui
