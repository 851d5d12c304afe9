// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/MeasurementLines.h"

#include "core/measure/PlaneShape.h"
#include "ui/base/Theme.h"
#include "ui/measure/MeasureTexts.h"
#include "ui/workspace/Pieces.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace ui {

namespace {

using Kind = core::Measurement::Kind;

constexpr double tickPixels = 5.0;
constexpr double headPixels = 9.0; ///< of an arrow
constexpr int circleCorners = 96;

/// Whether a place lies in a slice, as far as its voxels can tell: within half of what they are
/// apart across that slice, however far they are apart along it.
bool liesIn(
    const gpu::SliceScene& slice, const glm::dvec3& lps, const core::VolumeGeometry& geometry)
{
    constexpr double roundingMm = 1e-3; // points are kept in 1/1024 mm
    const glm::dvec3 normal = glm::cross(slice.rightLps, slice.downLps);
    double apart = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        apart =
            std::max(apart, std::abs(glm::dot(normal, glm::dvec3(geometry.indexToWorld[axis]))));
    return std::abs(glm::dot(lps - slice.centreLps, normal)) <= apart / 2.0 + roundingMm;
}

QPointF unit(const QPointF& way)
{
    const double length = std::hypot(way.x(), way.y());
    return length > 0.0 ? way / length : QPointF(1.0, 0.0);
}

QPointF across(const QPointF& way)
{
    return {-way.y(), way.x()};
}

QPolygonF circle(const QPointF& centre, double radius)
{
    QPolygonF corners;
    for (int i = 0; i < circleCorners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / circleCorners;
        corners << centre + radius * QPointF(std::cos(angle), std::sin(angle));
    }
    return corners;
}

void drawDistance(MeasurementDrawing& drawing, const QPointF& from, const QPointF& to)
{
    const QPointF side = tickPixels * across(unit(to - from));
    drawing.lines = {QPolygonF({from, to}), QPolygonF({from - side, from + side}),
        QPolygonF({to - side, to + side})};
    drawing.text = (from + to) / 2.0;
    drawing.away = unit(side.y() > 0.0 ? -side : side); // the side that looks up
}

void drawAngle(MeasurementDrawing& drawing, const std::vector<QPointF>& at)
{
    drawing.lines = {QPolygonF({at[0], at[1], at[2]})};
    // An arc between its sides.
    const QPointF from = unit(at[0] - at[1]);
    const QPointF to = unit(at[2] - at[1]);
    const double turn =
        std::atan2(from.x() * to.y() - from.y() * to.x(), from.x() * to.x() + from.y() * to.y());
    constexpr double radius = 14.0;
    constexpr int steps = 12;
    QPolygonF arc;
    for (int i = 0; i <= steps; ++i) {
        const double angle = turn * i / steps;
        arc << at[1] + radius * (std::cos(angle) * from + std::sin(angle) * across(from));
    }
    drawing.lines.push_back(arc);
    drawing.text = at[1];
    drawing.away = unit(-(from + to));
}

void drawArrow(MeasurementDrawing& drawing, const QPointF& tip, const QPointF& end)
{
    const QPointF back = headPixels * unit(end - tip);
    drawing.lines = {QPolygonF({tip, end}),
        QPolygonF({tip + back + across(back) / 2.0, tip, tip + back - across(back) / 2.0})};
    drawing.text = end;
    drawing.away = unit(end - tip);
}

void drawBall(
    MeasurementDrawing& drawing, const core::Measurement& measurement, const ViewContext& view)
{
    const glm::dvec3 centre = measurement.pointsLps[0];
    const double radius = glm::distance(centre, measurement.pointsLps[1]);
    double cut = radius;
    if (const auto* slice = std::get_if<gpu::SliceScene>(&view.scene)) {
        const double height =
            glm::dot(centre - slice->centreLps, glm::cross(slice->rightLps, slice->downLps));
        if (std::abs(height) > radius)
            return;
        cut = std::sqrt(radius * radius - height * height);
    }
    const double pixels = cut / view.mmPerPixel();
    const QPointF middle = view.toPixel(centre);
    drawing.outlines = {circle(middle, pixels)};
    drawing.marks = {middle};
    drawing.text = middle - QPointF(0.0, pixels);
}

void drawRegion(
    MeasurementDrawing& drawing, const core::Measurement& measurement, const ViewContext& view)
{
    const std::optional<core::PlaneShape> shape = core::planeShape(measurement);
    if (!shape)
        return;
    QPolygonF corners;
    for (const glm::dvec2& corner : shape->border(circleCorners))
        corners << view.toPixel(shape->toLps(corner));
    drawing.outlines = {corners};
    drawing.text = *std::min_element(corners.begin(), corners.end(),
        [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
}

/// Where it is shown: on a piece where that is. None: it is not shown in the view.
std::optional<core::Measurement> shownIn(const ViewContext& view, core::Measurement measured,
    const core::Document& document, const Workspace& workspace)
{
    const core::VolumeGeometry& geometry = workspace.volume()->geometry;
    if (view.isSlice()) {
        const bool inside = measured.kind == Kind::Ball || isShown(measured, view, workspace);
        return inside ? std::optional(measured) : std::nullopt;
    }
    const core::Piece* piece = document.piece(measured.piece);
    if (!piece)
        return measured;
    if (!workspace.pieces().look(piece->id).visible)
        return std::nullopt;
    core::Piece shown = *piece;
    shown.pose = workspace.pieces().pose(*piece);
    const glm::dmat4 pose = core::shownFromTrue(shown, geometry);
    for (glm::dvec3& point : measured.pointsLps)
        point = glm::dvec3(pose * glm::dvec4(point, 1.0));
    return measured;
}

/// Where a box stands in the room: where it should, or as near to that as it covers no other one;
/// where it should if there is no such place.
QRectF besideOthers(const QRectF& wanted, const QRectF& room, const std::vector<QRectF>& others)
{
    constexpr double stepPixels = 8.0;
    constexpr int rings = 24;
    const auto isFree = [&](const QRectF& box) {
        return room.contains(box)
            && std::none_of(others.begin(), others.end(),
                [&](const QRectF& each) { return each.intersects(box); });
    };
    if (isFree(wanted))
        return wanted;
    for (int ring = 1; ring <= rings; ++ring) {
        const double far = ring * stepPixels;
        for (const QPointF& way : {QPointF(0, -1), QPointF(0, 1), QPointF(-1, 0), QPointF(1, 0),
                 QPointF(-1, -1), QPointF(1, -1), QPointF(-1, 1), QPointF(1, 1)}) {
            if (const QRectF box = wanted.translated(far * way); isFree(box))
                return box;
        }
    }
    return wanted;
}

/// @returns the box of the words
QRectF paintWords(QPainter& painter, const ViewContext& view, const MeasurementDrawing& drawing,
    const QStringList& words, const std::vector<QRectF>& taken)
{
    painter.setFont(theme::smallFont());
    const QFontMetricsF metrics(painter.font());
    double width = 0.0;
    for (const QString& line : words)
        width = std::max(width, metrics.horizontalAdvance(line));
    QRectF box(QPointF(0, 0), QSizeF(width + 10.0, metrics.height() * double(words.size()) + 4.0));
    const QPointF away = drawing.away;
    box.moveCenter(drawing.text
        + away
            * (0.5 * box.height() * std::abs(away.y()) + 0.5 * box.width() * std::abs(away.x())
                + tickPixels));
    const QRectF room(QPointF(2, 2), view.sizePixels - QSizeF(4, 4));
    box.moveLeft(
        std::clamp(box.left(), room.left(), std::max(room.left(), room.right() - box.width())));
    box.moveTop(
        std::clamp(box.top(), room.top(), std::max(room.top(), room.bottom() - box.height())));
    const QRectF wanted = box;
    box = besideOthers(wanted, room, taken);
    if (!box.adjusted(-12, -12, 12, 12).contains(drawing.text)) {
        // A box that had to give way says whose it is.
        for (const QPen& pen : {QPen(QColor(0, 0, 0, 170), 3.0), QPen(theme::accent, 1.0)}) {
            painter.setPen(pen);
            painter.drawLine(drawing.text, box.center());
        }
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(theme::text);
    painter.drawText(box, Qt::AlignCenter, words.join(QLatin1Char('\n')));
    return box;
}

} // namespace

MeasurementDrawing drawingOf(const core::Measurement& measurement, const ViewContext& view)
{
    MeasurementDrawing drawing;
    std::vector<QPointF> at;
    for (const glm::dvec3& point : measurement.pointsLps)
        at.push_back(view.toPixel(point));
    drawing.text = at.front();
    switch (measurement.kind) {
    case Kind::Distance:
        drawDistance(drawing, at[0], at[1]);
        break;
    case Kind::Angle:
        drawAngle(drawing, at);
        break;
    case Kind::Ellipse:
    case Kind::Rectangle:
    case Kind::Outline:
        drawRegion(drawing, measurement, view);
        break;
    case Kind::Ball:
        drawBall(drawing, measurement, view);
        break;
    case Kind::Arrow:
        drawArrow(drawing, at[0], at[1]);
        break;
    case Kind::Probe:
    case Kind::Text:
        drawing.marks = {at[0]};
        break;
    }
    return drawing;
}

QRectF paintMeasurement(QPainter& painter, const ViewContext& view,
    const MeasurementDrawing& drawing, const QStringList& words, const std::vector<QRectF>& taken)
{
    if (drawing.lines.empty() && drawing.outlines.empty() && drawing.marks.empty())
        return {};
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 170), 3.6), QPen(theme::accent, 1.4)}) {
        painter.setPen(pen);
        for (const QPolygonF& line : drawing.lines)
            painter.drawPolyline(line);
        for (const QPolygonF& outline : drawing.outlines)
            painter.drawPolygon(outline);
        for (const QPointF& mark : drawing.marks) {
            painter.drawLine(mark - QPointF(4, 0), mark + QPointF(4, 0));
            painter.drawLine(mark - QPointF(0, 4), mark + QPointF(0, 4));
        }
    }
    QRectF box;
    if (!words.isEmpty())
        box = paintWords(painter, view, drawing, words, taken);
    painter.restore();
    return box;
}

bool isShown(
    const core::Measurement& measurement, const ViewContext& view, const Workspace& workspace)
{
    const auto* slice = std::get_if<gpu::SliceScene>(&view.scene);
    return !slice || !workspace.volume()
        || std::all_of(measurement.pointsLps.begin(), measurement.pointsLps.end(),
            [&](const glm::dvec3& point) {
                return liesIn(*slice, point, workspace.volume()->geometry);
            });
}

QStringList measurementLines(const core::Measurement& measurement, const Workspace& workspace)
{
    const core::Volume* volume = workspace.volume();
    if (!volume)
        return {};
    const core::Measured* known = workspace.measured(measurement);
    QStringList lines =
        sizeLines(measurement, known ? known->size : core::measuredSize(measurement, *volume));
    const bool hasValues = measurement.isRegion() || measurement.kind == Kind::Probe;
    if (!known || !hasValues)
        return lines;
    if (known->values)
        lines += valueLines(measurement, *known->values, *volume);
    else
        lines += QObject::tr("outside of the volume");
    return lines;
}

void paintMeasurements(QPainter& painter, const ViewContext& view, const Workspace& workspace)
{
    const core::EditSession* session = workspace.session();
    const core::Volume* volume = workspace.volume();
    if (!session || !volume)
        return;
    const core::Document& document = session->document();
    std::vector<std::pair<MeasurementDrawing, QStringList>> drawings;
    std::vector<QRectF> taken; // by small shapes, and by words
    for (const core::Measurement& measured : document.measurements) {
        const std::optional<core::Measurement> shown = shownIn(view, measured, document, workspace);
        if (!shown)
            continue;
        drawings.emplace_back(drawingOf(*shown, view), measurementLines(measured, workspace));
        for (const QPolygonF& outline : drawings.back().first.outlines)
            taken.push_back(outline.boundingRect());
    }
    for (const auto& [drawing, words] : drawings)
        taken.push_back(paintMeasurement(painter, view, drawing, words, taken));
}

} // namespace ui
