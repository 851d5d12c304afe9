// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/CutFrames.h"

#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/HalfSpaces.h"
#include "core/edits/engine/SegmentProtection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

namespace {

constexpr double fixed16 = 65536.0;
constexpr double fixed30 = 1073741824.0;
/// A pause in the material shorter than this (a suture, a marrow space, noise) is no gap.
constexpr double gapMm = 2.0;

double finestMm(const VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    return std::min({spacing.x, spacing.y, spacing.z});
}

} // namespace

Fixed3 toFixed30(const glm::dvec3& v)
{
    return {std::llround(v.x * fixed30), std::llround(v.y * fixed30), std::llround(v.z * fixed30)};
}

std::int32_t mm16(double mm)
{
    return std::int32_t(std::llround(mm * fixed16));
}

std::int32_t elementPitch(const VolumeGeometry& geometry, double maskReachMm)
{
    return std::max(mm16(std::max(finestMm(geometry) / 2.0, maskReachMm / 256.0)), 2);
}

Result<CutFrame> cutFrame(
    const CutFrameOptions& options, const Document& document, const QString& edit)
{
    if (document.volumes.empty())
        return failure(ErrorCode::InvalidField, edit, QStringLiteral("no volume"));
    if (const Result<void> checked =
            checkProtected(options.protectedSegments, options.restore, edit);
        !checked)
        return tl::unexpected(checked.error());
    const Volume& volume = document.volumes.front();
    const VolumeGeometry& geometry = volume.geometry;
    const OrthographicView& view = options.view;
    const double finest = finestMm(geometry);
    const Result<glm::dmat3> axes = viewAxes(view, edit + QStringLiteral(".view"));
    if (!axes)
        return tl::unexpected(axes.error());

    const glm::dmat3 worldToPlane = glm::transpose(*axes);
    double nearest = std::numeric_limits<double>::max();
    double farthest = std::numeric_limits<double>::lowest();
    for (const glm::dvec3& corner : geometry.cornersLps()) {
        const double z = (worldToPlane * (corner - view.targetLps)).z;
        nearest = std::min(nearest, z);
        farthest = std::max(farthest, z);
    }
    const double diagonal =
        glm::length(geometry.cornersLps().back() - geometry.cornersLps().front());
    if (std::max(std::abs(nearest), std::abs(farthest)) > 4.0 * diagonal + 1000.0)
        return failure(ErrorCode::InvalidField, edit + QStringLiteral(".view.targetLps"),
            Clause::saying("lies far outside the volume"));

    CutFrame frame;
    frame.pitch = elementPitch(geometry, options.maskReachMm);
    frame.zPerSample = std::max(mm16(finest / 2.0), 1);
    frame.rampHalfWidth = std::max(mm16(finest / 2.0), 1);
    frame.zStart = std::int32_t(std::floor(nearest * fixed16));
    frame.sampleCount = std::int32_t((farthest * fixed16 - frame.zStart) / frame.zPerSample) + 2;
    frame.thresholdCode = volume.encoding.lowestCodeAtLeast(options.surfaceThreshold);
    frame.maxDepth = mm16(options.maxDepthMm);
    frame.gapSamples = std::max(int(std::llround(gapMm * fixed16 / frame.zPerSample)), 1);
    frame.throughGaps = options.throughGaps;
    frame.restore = options.restore;
    frame.hidden = integerHalfSpaces(options.hidden, geometry);
    frame.protectedLabels = protectedLabelsOf(options.protectedSegments, document);

    const glm::dmat3 indexToPlane = worldToPlane * glm::dmat3(geometry.indexToWorld);
    frame.planeOrigin = toFixed30(worldToPlane * (geometry.originLps() - view.targetLps));
    frame.planePerI = toFixed30(indexToPlane[0]);
    frame.planePerJ = toFixed30(indexToPlane[1]);
    frame.planePerK = toFixed30(indexToPlane[2]);
    const std::int64_t acrossVoxel =
        std::abs(frame.planePerI[2]) + std::abs(frame.planePerJ[2]) + std::abs(frame.planePerK[2]);
    frame.front = std::max(2 * frame.rampHalfWidth, std::int32_t(fixedPoint::round14(acrossVoxel)));

    // The rounded pitch and steps are what the kernels use, so the rays are built from those.
    const double pitchMm = frame.pitch / fixed16;
    const double firstCentreMm = (frame.pitch / 2) / fixed16;
    const glm::dmat3 planeToIndex = glm::dmat3(geometry.worldToIndex()) * *axes;
    const glm::dvec3 firstCentre =
        planeToIndex * glm::dvec3(firstCentreMm, firstCentreMm, frame.zStart / fixed16);
    frame.rayOrigin = toFixed30(geometry.toIndex(view.targetLps) + firstCentre);
    frame.rayPerA = toFixed30(planeToIndex[0] * pitchMm);
    frame.rayPerB = toFixed30(planeToIndex[1] * pitchMm);
    frame.rayPerSample = toFixed30(planeToIndex[2] * (frame.zPerSample / fixed16));
    return frame;
}

} // namespace core
