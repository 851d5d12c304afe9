// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/CurveSketch.h"

#include "core/edits/kinds/splitting/LineAcross.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/DrillMask.h"
#include "ui/tools/common/EllipseCorners.h"

#include <QPainter>

#include <algorithm>

namespace ui {

namespace {

constexpr double leastStepPixels = 1.5;
constexpr double leastSidePixels = 4.0;

bool isDrawnByHand(CurveSketch::Shape shape)
{
    return shape == CurveSketch::Shape::Freehand || shape == CurveSketch::Shape::Line;
}

/// As far as a line that goes on at its ends is seen.
void paintBeyondEnds(QPainter& painter, const QPolygonF& line, const QSizeF& view)
{
    std::vector<glm::dvec2> points;
    for (const QPointF& point : line)
        points.emplace_back(point.x(), point.y());
    const std::optional<core::LineEnds> ends = core::lineEnds(points);
    if (!ends)
        return;
    const double far = view.width() + view.height();
    painter.drawLine(line.front(), line.front() + far * QPointF(ends->before.x, ends->before.y));
    painter.drawLine(line.back(), line.back() + far * QPointF(ends->behind.x, ends->behind.y));
}

} // namespace

void CurveSketch::begin(const QPointF& at, const ViewContext& view, Shape shape)
{
    m_view = view;
    m_shape = shape;
    m_points = isDrawnByHand(shape) ? QPolygonF({at}) : QPolygonF({at, at});
}

void CurveSketch::extend(const QPointF& at)
{
    if (!isDrawnByHand(m_shape)) {
        m_points.back() = at;
        return;
    }
    const QPointF step = at - m_points.back();
    if (QPointF::dotProduct(step, step) >= leastStepPixels * leastStepPixels)
        m_points << at;
}

QPolygonF CurveSketch::polygon() const
{
    if (isDrawnByHand(m_shape))
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
    const double side = m_shape == Shape::Line ? std::max(box.width(), box.height())
                                               : std::min(box.width(), box.height());
    std::vector<glm::dvec2> curve;
    if (hasCorners && side >= leastSidePixels)
        curve = curveMm();
    m_view.reset();
    return curve;
}

void CurveSketch::paint(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    if (!isDrawnByHand(m_shape))
        return drawToolOutline(painter, polygon(), true);
    // Where it closes or goes on by itself, a thin line says so.
    painter.setPen(QPen(toolColour(), 1.0, Qt::DotLine));
    if (m_shape == Shape::Line)
        paintBeyondEnds(painter, m_points, m_view->sizePixels);
    else
        painter.drawLine(m_points.back(), m_points.front());
    drawToolOutline(painter, m_points, false);
}

} // namespace ui
