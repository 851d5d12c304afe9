// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/ToolMasks.h"

#include "core/edits/engine/CutFrames.h"
#include "core/edits/kinds/sculpt/ToolMask.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

constexpr double fixed16 = 65536.0;

/// Sines may differ in the last bit between libraries; what follows must not.
double settled(double value)
{
    return double(std::llround(value * 1073741824.0)) / 1073741824.0;
}

glm::dvec2 directionAt(double degrees)
{
    const double radians = degrees * (3.14159265358979323846 / 180.0);
    return {settled(std::cos(radians)), settled(std::sin(radians))};
}

/// Part of an ellipse, from one angle to another.
void addArc(std::vector<glm::dvec2>& outline, const glm::dvec2& middle, const glm::dvec2& radii,
    double fromDegrees, double toDegrees, double sagMm)
{
    const double radius = std::max(radii.x, radii.y);
    const double step = 2.0 * std::acos(1.0 - std::min(sagMm / std::max(radius, 1e-6), 0.1));
    const double sweep = (toDegrees - fromDegrees) * (3.14159265358979323846 / 180.0);
    // A multiple of four, so that a circle is the same after a quarter turn.
    const int pieces = 4 * std::clamp(int(std::ceil(sweep / step / 4.0)), 1, 1024);
    for (int i = 0; i <= pieces; ++i)
        outline.push_back(
            middle + radii * directionAt(fromDegrees + (toDegrees - fromDegrees) * i / pieces));
}

} // namespace

bool isRound(const ToolMask& shape)
{
    return !shape.polygonMm && shape.kind == ToolMask::Kind::Circle;
}

double reachMm(const ToolMask& shape)
{
    if (shape.polygonMm) {
        double reach = 0.0;
        for (const glm::dvec2& point : *shape.polygonMm)
            reach = std::max(reach, std::sqrt(point.x * point.x + point.y * point.y));
        return reach;
    }
    switch (shape.kind) {
    case ToolMask::Kind::Circle:
        return shape.radiusMm;
    case ToolMask::Kind::Ellipse:
        return std::max(shape.widthMm, shape.heightMm) / 2.0;
    case ToolMask::Kind::Square:
        return shape.widthMm * std::sqrt(0.5);
    case ToolMask::Kind::Rectangle:
    case ToolMask::Kind::Rounded:
        break;
    }
    return std::sqrt(shape.widthMm * shape.widthMm + shape.heightMm * shape.heightMm) / 2.0;
}

std::vector<glm::dvec2> outlineMm(const ToolMask& shape, double elementMm)
{
    if (shape.polygonMm)
        return *shape.polygonMm;
    const double sag = elementMm / 64.0;
    const glm::dvec2 half(shape.widthMm / 2.0,
        (shape.kind == ToolMask::Kind::Square ? shape.widthMm : shape.heightMm) / 2.0);
    std::vector<glm::dvec2> outline;
    switch (shape.kind) {
    case ToolMask::Kind::Circle:
        addArc(outline, {0.0, 0.0}, glm::dvec2(shape.radiusMm), 0.0, 360.0, sag);
        break;
    case ToolMask::Kind::Ellipse:
        addArc(outline, {0.0, 0.0}, half, 0.0, 360.0, sag);
        break;
    case ToolMask::Kind::Square:
    case ToolMask::Kind::Rectangle:
        outline = {half, {-half.x, half.y}, -half, {half.x, -half.y}};
        break;
    case ToolMask::Kind::Rounded: {
        const double corner = std::min({shape.cornerMm, half.x, half.y});
        const glm::dvec2 middle = half - corner;
        for (int quarter = 0; quarter < 4; ++quarter) {
            const glm::dvec2 side(
                quarter == 1 || quarter == 2 ? -1.0 : 1.0, quarter >= 2 ? -1.0 : 1.0);
            addArc(outline, middle * side, glm::dvec2(corner), 90.0 * quarter, 90.0 * (quarter + 1),
                sag);
        }
        break;
    }
    }
    const glm::dvec2 turn = directionAt(shape.rotationDegrees);
    if (shape.kind != ToolMask::Kind::Circle) {
        for (glm::dvec2& point : outline)
            point = {turn.x * point.x - turn.y * point.y, turn.y * point.x + turn.x * point.y};
    }
    return outline;
}

Result<OutlineRaster> maskOf(const std::vector<glm::dvec2>& outlineMm, std::int32_t pitch,
    const glm::dvec2& origin, const QString& field)
{
    const double perMm = fixed16 / pitch;
    std::vector<OutlineVertex> vertices;
    vertices.reserve(outlineMm.size());
    for (const glm::dvec2& point : outlineMm) {
        const glm::dvec2 place = (point * perMm + origin) * double(outlineSubdivision);
        vertices.emplace_back(int(std::llround(place.x)), int(std::llround(place.y)));
    }
    const OutlineRaster filled = filledExactly(vertices);
    if (filled.area() < 256)
        return failure(ErrorCode::InvalidField, field,
            Clause::saying("is too small: it covers less than the %1 mm that a cut resolves",
                QString::number(pitch / fixed16, 'f', 2)));
    return smoothed(filled);
}

Result<OutlineRaster> maskUnderSample(
    const ToolMask& shape, std::int32_t pitch, const QString& field)
{
    Result<OutlineRaster> mask =
        maskOf(outlineMm(shape, pitch / fixed16), pitch, glm::dvec2(0.5), field);
    if (mask)
        *mask = softened(*mask, (std::int64_t(mm16(shape.softnessMm)) << 8) / pitch);
    return mask;
}

} // namespace core
