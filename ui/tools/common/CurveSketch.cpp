// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/CurveSketch.h"

#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/DrillMask.h"

#include <QPainter>

namespace ui {

namespace {

constexpr double leastStepPixels = 1.5;
constexpr double leastSidePixels = 4.0;

} // namespace

void CurveSketch::begin(const QPointF& at, const ViewContext& view)
{
    m_view = view;
    m_points = QPolygonF({at});
}

void CurveSketch::extend(const QPointF& at)
{
    const QPointF step = at - m_points.back();
    if (QPointF::dotProduct(step, step) >= leastStepPixels * leastStepPixels)
        m_points << at;
}

std::vector<glm::dvec2> CurveSketch::curveMm() const
{
    std::vector<glm::dvec2> curve;
    for (const QPointF& point : m_points)
        curve.push_back(m_view->toViewPlaneMm(point));
    return curve;
}

std::vector<glm::dvec2> CurveSketch::finish()
{
    const QRectF box = m_points.boundingRect();
    std::vector<glm::dvec2> curve;
    if (m_points.size() >= 3 && box.width() >= leastSidePixels && box.height() >= leastSidePixels)
        curve = curveMm();
    m_view.reset();
    return curve;
}

void CurveSketch::paint(QPainter& painter) const
{
    // Where it closes by itself, a thin line says so.
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(toolColour(), 1.0, Qt::DotLine));
    painter.drawLine(m_points.back(), m_points.front());
    drawToolOutline(painter, m_points, false);
}

} // namespace ui
