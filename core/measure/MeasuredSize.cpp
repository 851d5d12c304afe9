// SPDX-License-Identifier: Apache-2.0
#include "core/measure/MeasuredSize.h"

#include "core/measure/PlaneShape.h"
#include "core/measure/WoundArea.h"
#include "core/volume/UnevenSlices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core {

namespace {

/// A point up to this far from a slice counts as lying in it, because points are rounded.
constexpr double inSliceVoxels = 0.05;
/// The corners that stand for an ellipse between uneven slices; they lack 0.001 % of its area.
constexpr int finelyCornered = 1024;

double volumeOfBall(double radius)
{
    return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

bool liesInOneSlice(const Measurement& measurement, const VolumeGeometry& geometry)
{
    if (measurement.kind == Measurement::Kind::Ball)
        return false;
    const double first = geometry.toIndex(measurement.pointsLps.front()).z;
    return std::all_of(
        measurement.pointsLps.begin(), measurement.pointsLps.end(), [&](const glm::dvec3& point) {
            return std::abs(geometry.toIndex(point).z - first) <= inSliceVoxels;
        });
}

double angleDegrees(const glm::dvec3& a, const glm::dvec3& b)
{
    // Exact for small angles too, unlike an arc cosine.
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

double flatArea(const std::vector<glm::dvec3>& corners)
{
    glm::dvec3 twice(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        twice += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return glm::length(twice) / 2.0;
}

/// The part of a convex polygon, in index space, on one side of a height.
std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& corners, double z, double side)
{
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3& from = corners[i];
        const glm::dvec3& to = corners[(i + 1) % corners.size()];
        const double here = (from.z - z) * side;
        const double there = (to.z - z) * side;
        if (here >= 0.0)
            kept.push_back(from);
        if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0))
            kept.push_back(from + (to - from) * (here / (here - there)));
    }
    return kept;
}

/// Between two slices places lie evenly, so that each such part of a trapezoid stays flat.
double unevenArea(const PlaneShape& shape, const VolumeGeometry& geometry)
{
    const int last = geometry.size.z - 1;
    double area = 0.0;
    for (const Trapezoid& trapezoid : woundTrapezoids(shape.border(finelyCornered))) {
        std::vector<glm::dvec3> corners;
        for (const glm::dvec2& corner : trapezoid)
            corners.push_back(geometry.toIndex(shape.toLps(corner)));
        const auto [low, high] = std::minmax_element(corners.begin(), corners.end(),
            [](const glm::dvec3& a, const glm::dvec3& b) { return a.z < b.z; });
        // Beyond an outermost slice the spacing continues as before it.
        const int from = std::clamp(int(std::floor(low->z)), 0, std::max(0, last - 1));
        const int to = std::clamp(int(std::floor(high->z)), 0, std::max(0, last - 1));
        for (int k = from; k <= to; ++k) {
            std::vector<glm::dvec3> part = corners;
            if (k > from)
                part = clipped(part, k, 1.0);
            if (k < to)
                part = clipped(part, k + 1, -1.0);
            for (glm::dvec3& corner : part) {
                // Computed by this slab's own step, also at its upper border, where the next slab
                // begins.
                const glm::dvec3 below =
                    worldBetweenSlices(geometry, {corner.x, corner.y, double(k)});
                const glm::dvec3 middle =
                    worldBetweenSlices(geometry, {corner.x, corner.y, k + 0.5});
                corner = below + (middle - below) * (2.0 * (corner.z - k));
            }
            area += flatArea(part);
        }
    }
    return area;
}

} // namespace

UnknownSpacing unknownSpacing(const Volume& volume)
{
    UnknownSpacing unknown = UnknownSpacing::Nothing;
    for (const VolumeProblem& problem : volume.problems) {
        if (problem.kind != VolumeProblem::Kind::AssumedSpacing || !problem.repairedBy.isEmpty())
            continue;
        switch (problem.said.code) {
        case ProblemCode::DepthTakenFrom: // a single image; its file says how thick it is
            break;
        case ProblemCode::DepthAssumed:
        case ProblemCode::ThicknessAssumed:
        case ProblemCode::PicturesWithoutDistance:
            unknown = std::max(unknown, UnknownSpacing::BetweenSlices);
            break;
        default:
            unknown = UnknownSpacing::Everything;
        }
    }
    return unknown;
}

glm::dvec3 truePlace(const VolumeGeometry& geometry, const glm::dvec3& shownLps)
{
    return geometry.slicePositions.empty()
        ? shownLps
        : worldBetweenSlices(geometry, geometry.toIndex(shownLps));
}

MeasuredSize measuredSize(const Measurement& measurement, const Volume& volume)
{
    using Kind = Measurement::Kind;
    const VolumeGeometry& geometry = volume.geometry;
    const UnknownSpacing unknown = unknownSpacing(volume);
    MeasuredSize size;
    if (measurement.pointsLps.size() < pointsOf(measurement.kind))
        return size;
    size.inVoxels = unknown == UnknownSpacing::Everything
        || (unknown == UnknownSpacing::BetweenSlices && !liesInOneSlice(measurement, geometry));
    Measurement placed = measurement;
    for (glm::dvec3& point : placed.pointsLps)
        point = size.inVoxels ? geometry.toIndex(point) : truePlace(geometry, point);
    const std::vector<glm::dvec3>& at = placed.pointsLps;
    switch (measurement.kind) {
    case Kind::Distance:
        size.length = glm::distance(at[0], at[1]);
        break;
    case Kind::Angle:
        size.angleDegrees = angleDegrees(at[0] - at[1], at[2] - at[1]);
        break;
    case Kind::Ellipse: {
        const glm::dvec2 axes = 2.0 * halfAxes(at[1] - at[0], at[2] - at[0]);
        size.longAxis = axes.x;
        size.shortAxis = axes.y;
        break;
    }
    case Kind::Rectangle: {
        const double a = glm::distance(at[1], at[0]);
        const double b = glm::distance(at[2], at[0]);
        size.longAxis = std::max(a, b);
        size.shortAxis = std::min(a, b);
        break;
    }
    case Kind::Ball: {
        size.longAxis = 2.0 * glm::distance(at[0], at[1]);
        // A ball of millimetres is none in voxels, but holds as many of them.
        const double radiusMm = glm::distance(truePlace(geometry, measurement.pointsLps[0]),
            truePlace(geometry, measurement.pointsLps[1]));
        size.volume = volumeOfBall(radiusMm) / (size.inVoxels ? geometry.voxelVolumeMm3() : 1.0);
        break;
    }
    case Kind::Outline:
    case Kind::Probe:
    case Kind::Arrow:
    case Kind::Text:
        break;
    }
    if (!measurement.isPlaneRegion())
        return size;
    const bool uneven = !geometry.slicePositions.empty() && !size.inVoxels;
    const std::optional<PlaneShape> shape = planeShape(uneven ? measurement : placed);
    if (shape)
        size.area = uneven ? unevenArea(*shape, geometry) : shape->areaMm2();
    return size;
}

} // namespace core
