// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/aim/DrillMask.h"

#include "core/edits/kinds/sculpt/ToolMask.h"
#include "core/edits/kinds/sculpt/ToolMasks.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/SweepAim.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double radian = 180.0 / 3.14159265358979323846; ///< degrees
/// A pen that leans less does so by chance: which way means nothing.
constexpr double leastLean = 0.176; ///< tan 10°
constexpr double outlineElementMm = 0.25;

/// Where the pen's upper end leans to, right and up; as long as the tangent of its tilt.
glm::dvec2 leanOf(const PointerSample& pen)
{
    return {tiltTangent(pen.tiltDegrees.x()), -tiltTangent(pen.tiltDegrees.y())};
}

/// Degrees counter-clockwise.
double azimuth(const glm::dvec2& lean)
{
    return std::atan2(lean.y, lean.x) * radian;
}

double turnOf(const PointerSample& pen)
{
    if (pen.rotationDegrees)
        return -*pen.rotationDegrees;
    const glm::dvec2 lean = leanOf(pen);
    return glm::length(lean) < leastLean ? 0.0 : azimuth(lean);
}

/// What is left of a length along the way that a pen leans.
double shareOf(const glm::dvec2& lean)
{
    return 1.0 / std::sqrt(1.0 + glm::dot(lean, lean));
}

constexpr double wholeShare = 0.999;

void stretch(std::vector<glm::dvec2>& points, const glm::dvec2& along, double factor)
{
    for (glm::dvec2& point : points)
        point += (factor - 1.0) * glm::dot(point, along) * along;
}

void turn(std::vector<glm::dvec2>& points, double degrees)
{
    const double cosine = std::cos(degrees / radian);
    const double sine = std::sin(degrees / radian);
    for (glm::dvec2& point : points)
        point = {cosine * point.x - sine * point.y, sine * point.x + cosine * point.y};
}

void foreshorten(core::ToolMask& mask, const glm::dvec2& lean)
{
    const double share = shareOf(lean);
    if (share > wholeShare)
        return;
    if (core::isRound(mask)) {
        mask.kind = core::ToolMask::Kind::Ellipse;
        mask.widthMm = 2.0 * mask.radiusMm * share;
        mask.heightMm = 2.0 * mask.radiusMm;
        mask.rotationDegrees = azimuth(lean);
        return;
    }
    std::vector<glm::dvec2> outline = core::outlineMm(mask, outlineElementMm);
    stretch(outline, glm::normalize(lean), share);
    mask.polygonMm = std::move(outline);
}

/// Degrees that a mask is turned by, counter-clockwise.
double turnOf(const Workspace::DrillSettings& settings, const PointerSample& pen)
{
    const double withPen = settings.turnsWithPen ? turnOf(pen) : 0.0;
    return std::remainder(settings.rotationDegrees + withPen, 360.0);
}

} // namespace

core::ToolMask drillMask(const Workspace::DrillSettings& settings, const PointerSample& pen)
{
    core::ToolMask mask;
    mask.kind = settings.shape;
    mask.radiusMm = settings.radiusMm;
    mask.widthMm = 2.0 * settings.radiusMm;
    mask.heightMm = std::max(mask.widthMm * settings.heightRatio, 0.1);
    mask.cornerMm = 0.25 * std::min(mask.widthMm, mask.heightMm);
    mask.rotationDegrees = turnOf(settings, pen);
    mask.softnessMm = settings.softnessMm;
    if (settings.freehand && !settings.outline.empty()) {
        mask.polygonMm = settings.outline;
        for (glm::dvec2& point : *mask.polygonMm)
            point *= settings.radiusMm;
        turn(*mask.polygonMm, mask.rotationDegrees);
    }
    if (settings.foreshortened)
        foreshorten(mask, leanOf(pen));
    return mask;
}

std::vector<glm::dvec2> withoutPen(std::vector<glm::dvec2> curve,
    const Workspace::DrillSettings& settings, const PointerSample& pen)
{
    const glm::dvec2 lean = leanOf(pen);
    if (settings.foreshortened && shareOf(lean) <= wholeShare)
        stretch(curve, glm::normalize(lean), 1.0 / shareOf(lean));
    turn(curve, -turnOf(settings, pen));
    return curve;
}

void drawToolOutline(QPainter& painter, const QPolygonF& outline, bool closed)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 150), 3.5), QPen(toolColour(), 1.6)}) {
        painter.setPen(pen);
        if (closed)
            painter.drawPolygon(outline);
        else
            painter.drawPolyline(outline);
    }
}

void paintPatch(QPainter& painter, const SurfacePatch& surface, const ViewContext& view)
{
    QColor fill = toolColour();
    fill.setAlphaF(0.22F);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    for (const QPolygonF& square : surface.squares(view))
        painter.drawPolygon(square);
}

QPolygonF maskOutline(const core::ToolMask& mask, const QPointF& centre, double mmPerPixel)
{
    QPolygonF outline;
    for (const glm::dvec2& point : core::outlineMm(mask, mmPerPixel))
        outline << centre + QPointF(point.x, -point.y) / mmPerPixel;
    return outline;
}

} // namespace ui
