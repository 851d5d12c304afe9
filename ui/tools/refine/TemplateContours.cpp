// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/refine/TemplateContours.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

namespace {

/// A shorter line is a slip of the pen.
constexpr double leastContourPixels = 6.0;
/// A contour that ends this near to its beginning is closed.
constexpr double closingPixels = 12.0;
/// A contour that is farther from a plane than this does not lie in it.
constexpr double inPlaneMm = 0.5;

/// The greatest distance of a contour from the plane of a slice; 0 in other views.
double offPlaneMm(const TemplateContour& contour, const ViewContext& view)
{
    const auto* slice = std::get_if<gpu::SliceScene>(&view.scene);
    if (!slice)
        return 0.0;
    const glm::dvec3 across = glm::cross(slice->rightLps, slice->downLps);
    double offMm = 0.0;
    for (const glm::dvec3& point : contour)
        offMm = std::max(offMm, std::abs(glm::dot(point - slice->centreLps, across)));
    return offMm;
}

QPolygonF pixelsOf(const TemplateContour& contour, const ViewContext& view)
{
    QPolygonF line;
    for (const glm::dvec3& point : contour)
        line << view.toPixel(point);
    return line;
}

/// The distance of a place from a straight line between two others.
double distanceOf(const QPointF& place, const QPointF& from, const QPointF& to)
{
    const QPointF way = to - from;
    const double length = QPointF::dotProduct(way, way);
    const double share =
        length > 0.0 ? std::clamp(QPointF::dotProduct(place - from, way) / length, 0.0, 1.0) : 0.0;
    const QPointF off = place - from - share * way;
    return std::hypot(off.x(), off.y());
}

} // namespace

std::optional<TemplateContour> drawnContour(TemplateContour line, double pixelMm)
{
    double lengthMm = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i)
        lengthMm += glm::distance(line[i - 1], line[i]);
    if (line.size() < 2 || lengthMm < leastContourPixels * pixelMm)
        return std::nullopt;
    // A contour has three points at least; a flick of the pen may have two.
    if (line.size() == 2)
        line.insert(line.begin() + 1, 0.5 * (line.front() + line.back()));
    // A line that comes back to where it began is meant to be closed.
    if (lengthMm > 4.0 * closingPixels * pixelMm
        && glm::distance(line.front(), line.back()) < closingPixels * pixelMm)
        line.back() = line.front();
    return line;
}

bool isRubbed(
    const TemplateContour& contour, const ViewContext& view, const QPointF& from, const QPointF& to)
{
    if (!view.isSlice() || offPlaneMm(contour, view) >= inPlaneMm)
        return false;
    const QPolygonF line = pixelsOf(contour, view);
    // Events of a fast hand lie far apart: the way between them is walked.
    const QPointF way = to - from;
    const int steps = std::max(1, int(std::ceil(std::hypot(way.x(), way.y()) / rubberPixels)));
    for (int step = 0; step <= steps; ++step) {
        const QPointF place = from + double(step) / double(steps) * way;
        for (qsizetype i = 1; i < line.size(); ++i) {
            if (distanceOf(place, line[i - 1], line[i]) <= rubberPixels)
                return true;
        }
    }
    return false;
}

void paintContour(QPainter& painter, const TemplateContour& contour, const ViewContext& view,
    const QColor& colour)
{
    const QPolygonF line = pixelsOf(contour, view);
    const int alpha = offPlaneMm(contour, view) < inPlaneMm ? 255 : 90;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, alpha / 2), 3.4));
    painter.drawPolyline(line);
    QColor shown = colour;
    shown.setAlpha(alpha);
    painter.setPen(QPen(shown, 1.6));
    painter.drawPolyline(line);
}

} // namespace ui
