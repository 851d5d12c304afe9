// SPDX-License-Identifier: Apache-2.0
#include "core/refine/deform/BoundaryForce.h"

#include <algorithm>

namespace core {

namespace {

constexpr double level = 0.5;
constexpr double stepVoxels = 0.25;
/// A regular hexagon of edge a with its corners on a sphere of radius r lies 7/24 a²/r below it, in
/// the mean.
constexpr double cutShare = 7.0 / 24.0;
/// In distances of neighbours.
constexpr double mostCut = 0.1;
/// Of the occupancy over the width of a voxel, to tell where the outside is.
constexpr double leastFall = 0.1;
/// Of the angle between that and the normal, for the normal to tell the side: 60 degrees.
constexpr double leastCosine = 0.5;
constexpr int halvings = 2;

} // namespace

BoundaryForce::BoundaryForce(
    const BoxMask& mask, const VolumeGeometry& geometry, double reachVoxels)
    : m_toIndex(geometry)
    , m_occupancy(mask)
    , m_reachVoxels(reachVoxels)
    , m_indexPerMm(glm::transpose(glm::dmat3(geometry.worldToIndex())))
{
    const glm::dvec3 spacing = geometry.spacingMm();
    m_widthMm = std::min({spacing.x, spacing.y, spacing.z});
}

glm::dvec3 BoundaryForce::forceMm(const SurfacePoint& point) const
{
    if (point.mark != SurfaceMark::Yellow)
        return glm::dvec3(0.0);
    const glm::dvec3 normal = wayOut(point.positionLps, point.normalLps);
    const auto offMm = alongNormalMm(point.positionLps, normal);
    if (!offMm)
        return glm::dvec3(0.0);
    const double most = mostCut * point.distanceMm;
    const double cutMm = std::clamp(
        cutShare * point.curvaturePerMm * point.distanceMm * point.distanceMm, -most, most);
    return (*offMm + cutMm) * normal;
}

glm::dvec3 BoundaryForce::wayOut(const glm::dvec3& positionLps, const glm::dvec3& normalLps) const
{
    // As it falls per mm: a rise along the axes of the index, by how these change with the place.
    const glm::dvec3 index = m_toIndex(positionLps);
    const glm::dvec3 fall = -(m_indexPerMm * m_occupancy.rise(index));
    const double steep = glm::length(fall);
    const double along = glm::dot(fall, normalLps);
    const double sure = leastCosine * steep;
    const bool isThrough = along <= -sure && m_occupancy.at(index) >= level;
    if (steep * m_widthMm < leastFall || along >= sure || isThrough)
        return normalLps;
    return fall / steep;
}

std::optional<double> BoundaryForce::alongNormalMm(
    const glm::dvec3& positionLps, const glm::dvec3& normalLps) const
{
    const glm::dvec3 from = m_toIndex(positionLps);
    const glm::dvec3 perMm = glm::abs(m_toIndex(positionLps + normalLps) - from);
    const double fastest = std::max({perMm.x, perMm.y, perMm.z});
    if (!(fastest > 0.0))
        return std::nullopt;
    SmoothOccupancy::Walk walk(m_occupancy);
    const double here = walk.at(from) - level;
    const double side = here >= 0.0 ? 1.0 : -1.0;
    const double stepMm = side * stepVoxels / fastest;
    const auto offAt = [&](double mm) {
        return walk.at(m_toIndex(positionLps + mm * normalLps)) - level;
    };
    double nearMm = 0.0;
    double nearOff = here;
    for (int step = 1; step * stepVoxels <= m_reachVoxels; ++step) {
        double farMm = step * stepMm;
        double farOff = offAt(farMm);
        if (side * farOff >= 0.0) {
            nearMm = farMm;
            nearOff = farOff;
            continue;
        }
        for (int halving = 0; halving < halvings; ++halving) {
            const double middleMm = 0.5 * (nearMm + farMm);
            const double middleOff = offAt(middleMm);
            if (side * middleOff >= 0.0) {
                nearMm = middleMm;
                nearOff = middleOff;
            } else {
                farMm = middleMm;
                farOff = middleOff;
            }
        }
        return nearMm + (farMm - nearMm) * nearOff / (nearOff - farOff);
    }
    return std::nullopt;
}

} // namespace core
