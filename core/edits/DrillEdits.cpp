// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EngineEdits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

namespace {

constexpr double fixed16 = 65536.0;
constexpr double fixed30 = 1073741824.0;
/// A pause in the material shorter than this (a suture, a marrow space, noise) is no gap.
constexpr double gapMm = 2.0;

std::int32_t mm16(double mm)
{
    return std::int32_t(std::llround(mm * fixed16));
}

Fixed3 toFixed30(const glm::dvec3& v)
{
    return {std::llround(v.x * fixed30), std::llround(v.y * fixed30), std::llround(v.z * fixed30)};
}

Result<void> checkRange(const char* field, double value, double minimum, double maximum)
{
    if (value >= minimum && value <= maximum)
        return {};
    return failure(ErrorCode::InvalidField, QStringLiteral("drill.") + QLatin1String(field),
        QStringLiteral("%1 is outside %2 … %3").arg(value).arg(minimum).arg(maximum));
}

std::int32_t depthAt(const DrillFrame& frame, int exponent, std::int64_t pressure)
{
    std::int64_t factor = pressure;
    for (int power = 1; power < exponent; ++power)
        factor = factor * pressure / 65535;
    return std::int32_t(frame.maxDepth * factor / 65535);
}

} // namespace

Result<glm::dmat3> viewAxes(const OrthographicView& view, const QString& field)
{
    const glm::dvec3 towards = view.targetLps - view.eyeLps;
    if (!(glm::length(towards) > 1e-6))
        return failure(ErrorCode::InvalidField, field,
            QStringLiteral("eyeLps and targetLps are the same point"));
    const glm::dvec3 forward = glm::normalize(towards);
    const glm::dvec3 across = glm::cross(forward, view.up);
    if (!(glm::length(across) > 1e-6))
        return failure(ErrorCode::InvalidField, field + QStringLiteral(".up"),
            QStringLiteral("points along the view direction"));
    const glm::dvec3 right = glm::normalize(across);
    return glm::dmat3(right, glm::cross(right, forward), forward);
}

Result<DrillCut> drillCut(const DrillStroke& stroke, const Document& document)
{
    if (document.volumes.empty())
        return failure(
            ErrorCode::InvalidField, QStringLiteral("drill"), QStringLiteral("no volume"));
    const Volume& volume = document.volumes.front();
    const VolumeGeometry& geometry = volume.geometry;
    const glm::dvec3 spacing = geometry.spacingMm();
    const double finest = std::min({spacing.x, spacing.y, spacing.z});

    for (const Result<void>& check : {checkRange("mask.radiusMm", stroke.radiusMm, 0.01, 200.0),
             checkRange("depthMm", stroke.depthMm, 0.0, 500.0),
             checkRange("pressureExponent", stroke.pressureExponent, 1, 3),
             checkRange("layer", stroke.layer, 1, 254)}) {
        if (!check)
            return tl::unexpected(check.error());
    }
    const Result<glm::dmat3> axes = viewAxes(stroke.view, QStringLiteral("drill.view"));
    if (!axes)
        return tl::unexpected(axes.error());

    const glm::dmat3 worldToPlane = glm::transpose(*axes);
    double nearest = std::numeric_limits<double>::max();
    double farthest = std::numeric_limits<double>::lowest();
    for (const glm::dvec3& corner : geometry.cornersLps()) {
        const double z = (worldToPlane * (corner - stroke.view.targetLps)).z;
        nearest = std::min(nearest, z);
        farthest = std::max(farthest, z);
    }
    const double diagonal =
        glm::length(geometry.cornersLps().back() - geometry.cornersLps().front());
    if (std::max(std::abs(nearest), std::abs(farthest)) > 4.0 * diagonal + 1000.0)
        return failure(ErrorCode::InvalidField, QStringLiteral("drill.view.targetLps"),
            QStringLiteral("lies far outside the volume"));

    DrillFrame frame;
    // Half a voxel resolves the mask; a mask wider than 256 elements needs no finer ones.
    frame.pitch = std::max(mm16(std::max(finest / 2.0, stroke.radiusMm / 256.0)), 2);
    frame.zPerSample = std::max(mm16(finest / 2.0), 1);
    frame.rampHalfWidth = std::max(mm16(finest / 2.0), 1);
    frame.zStart = std::int32_t(std::floor(nearest * fixed16));
    frame.sampleCount = std::int32_t((farthest * fixed16 - frame.zStart) / frame.zPerSample) + 2;
    frame.thresholdCode = volume.encoding.lowestCodeAtLeast(stroke.surfaceThreshold);
    frame.maskRadius = mm16(stroke.radiusMm);
    frame.maxDepth = mm16(stroke.depthMm);
    frame.gapSamples = std::max(int(std::llround(gapMm * fixed16 / frame.zPerSample)), 1);
    frame.throughGaps = stroke.throughGaps;

    const glm::dmat3 indexToPlane = worldToPlane * glm::dmat3(geometry.indexToWorld);
    frame.planeOrigin = toFixed30(worldToPlane * (geometry.originLps() - stroke.view.targetLps));
    frame.planePerI = toFixed30(indexToPlane[0]);
    frame.planePerJ = toFixed30(indexToPlane[1]);
    frame.planePerK = toFixed30(indexToPlane[2]);

    // The rounded pitch and steps are what the kernels use, so the rays are built from those.
    const double pitchMm = frame.pitch / fixed16;
    const double firstCentreMm = (frame.pitch / 2) / fixed16;
    const glm::dmat3 planeToIndex = glm::dmat3(geometry.worldToIndex()) * *axes;
    const glm::dvec3 firstCentre =
        planeToIndex * glm::dvec3(firstCentreMm, firstCentreMm, frame.zStart / fixed16);
    frame.rayOrigin = toFixed30(geometry.toIndex(stroke.view.targetLps) + firstCentre);
    frame.rayPerA = toFixed30(planeToIndex[0] * pitchMm);
    frame.rayPerB = toFixed30(planeToIndex[1] * pitchMm);
    frame.rayPerSample = toFixed30(planeToIndex[2] * (frame.zPerSample / fixed16));
    return DrillCut{.layer = std::uint8_t(stroke.layer), .frame = frame};
}

std::vector<DrillSample> drillPath(const DrillStroke& stroke, const DrillFrame& frame,
    const PenSample* from, const std::vector<PenSample>& samples)
{
    // Beyond this the mask cannot reach the volume, and coordinates would leave their range.
    constexpr double farMm = 8000.0;
    const std::int64_t spacing = std::max(frame.maskRadius / 4, frame.pitch / 2);
    std::vector<DrillSample> path;
    for (const PenSample& sample : samples) {
        if (!(std::abs(sample.xMm) < farMm && std::abs(sample.yMm) < farMm))
            continue;
        const std::int64_t x = mm16(sample.xMm);
        const std::int64_t y = mm16(sample.yMm);
        const auto pressure =
            std::int64_t(std::llround(std::clamp(sample.pressure, 0.0, 1.0) * 65535));
        std::int64_t startX = x;
        std::int64_t startY = y;
        std::int64_t startPressure = pressure;
        std::int64_t pieces = 1;
        if (from && std::abs(from->xMm) < farMm && std::abs(from->yMm) < farMm) {
            startX = mm16(from->xMm);
            startY = mm16(from->yMm);
            startPressure = std::llround(std::clamp(from->pressure, 0.0, 1.0) * 65535);
            const auto length = std::int64_t(
                std::sqrt(double((x - startX) * (x - startX) + (y - startY) * (y - startY))));
            pieces = std::max<std::int64_t>(1, (length + spacing - 1) / spacing);
        }
        for (std::int64_t piece = 1; piece <= pieces; ++piece) {
            path.push_back({.x = std::int32_t(startX + (x - startX) * piece / pieces),
                .y = std::int32_t(startY + (y - startY) * piece / pieces),
                .depth = depthAt(frame, stroke.pressureExponent,
                    startPressure + (pressure - startPressure) * piece / pieces)});
        }
        from = &sample;
    }
    return path;
}

} // namespace core
