// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/CurveSketch.h"

#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/DrillMask.h"
#include "ui/tools/common/EllipseCorners.h"

#include <QPainter>

namespace ui {

namespace {

constexpr double leastStepPixels = 1.5;
constexpr double leastSidePixels = 4.0;

} // namespace

void CurveSketch::begin(const QPointF& at, const ViewContext& view, Shape shape)
{
    m_view = view;
    m_shape = shape;
    m_points = shape == Shape::Freehand ? QPolygonF({at}) : QPolygonF({at, at});
}

void CurveSketch::extend(const QPointF& at)
{
    if (m_shape != Shape::Freehand) {
        m_points.back() = at;
        return;
    }
    const QPointF step = at - m_points.back();
    if (QPointF::dotProduct(step, step) >= leastStepPixels * leastStepPixels)
        m_points << at;
}

QPolygonF CurveSketch::polygon() const
{
    if (m_shape == Shape::Freehand)
        return m_points;
    const QRectF box = QRectF(m_points.front(), m_points.back()).normalized();
    if (m_shape == Shape::Rectangle)
        return {{box.topLeft(), box.topRight(), box.bottomRight(), box.bottomLeft()}};
    QPolygonF ellipse;
    const glm::dvec2 centre(box.center().x(), box.center().y());
    for (const glm::dvec2& corner :
        ellipseCorners(centre, glm::dvec2(box.width(), box.height()) / 2.0))
        ellipse << QPointF(corner.x, corner.y);
    return ellipse;
}

std::vector<glm::dvec2> CurveSketch::curveMm() const
{
    std::vector<glm::dvec2> curve;
    for (const QPointF& point : polygon())
        curve.push_back(m_view->toViewPlaneMm(point));
    return curve;
}

std::vector<glm::dvec2> CurveSketch::finish()
{
    const QRectF box = m_points.boundingRect();
    const bool hasCorners = m_shape != Shape::Freehand || m_points.size() >= 3;
    std::vector<glm::dvec2> curve;
    if (hasCorners && box.width() >= leastSidePixels && box.height() >= leastSidePixels)
        curve = curveMm();
    m_view.reset();
    return curve;
}

void CurveSketch::paint(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_shape != Shape::Freehand)
        return drawToolOutline(painter, polygon(), true);
    // Where it closes by itself, a thin line says so.
    painter.setPen(QPen(toolColour(), 1.0, Qt::DotLine));
    painter.drawLine(m_points.back(), m_points.front());
    drawToolOutline(painter, m_points, false);
}

} // namespace ui
