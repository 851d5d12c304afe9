// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/ShownSurface.h"

#include "core/volume/WorldToIndex.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// The true steps from voxel to voxel about a slice, as columns.
glm::dmat3 trueSteps(const VolumeGeometry& geometry, double slice)
{
    glm::dmat3 steps(geometry.indexToWorld);
    const int last = int(geometry.slicePositions.size()) - 1;
    if (last > 0) {
        const auto k = std::size_t(std::clamp(int(std::floor(slice)), 0, last - 1));
        steps[2] = geometry.slicePositions[k + 1] - geometry.slicePositions[k];
    }
    return steps;
}

glm::dvec3 directionOf(const glm::dvec3& vector)
{
    const double length = glm::length(vector);
    return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

/// Turns a normal as the surface is bent whose steps become others: as it stays at right angles to
/// what lies in the surface, it follows the inverse of the transpose.
glm::dvec3 turned(const glm::dvec3& normal, const glm::dmat3& steps, const glm::dmat3& others)
{
    return directionOf(glm::inverse(glm::transpose(others)) * (glm::transpose(steps) * normal));
}

} // namespace

void moveToShown(SurfaceUpdate& update, const VolumeGeometry& geometry)
{
    if (geometry.slicePositions.empty())
        return;
    const WorldToIndex toIndex(geometry);
    const glm::dmat3 shownSteps(geometry.indexToWorld);
    for (SurfaceUpdate::Vertex& vertex : update.vertices) {
        const glm::dvec3 index = toIndex(vertex.positionLps);
        vertex.positionLps = geometry.toWorld(index);
        vertex.normalLps = turned(vertex.normalLps, trueSteps(geometry, index.z), shownSteps);
    }
}

MarkedRegion shownRegion(const MarkedRegion& region, const VolumeGeometry& geometry)
{
    MarkedRegion shown = region;
    if (geometry.slicePositions.empty())
        return shown;
    const glm::dvec3 index = WorldToIndex(geometry)(region.middleLps);
    shown.middleLps = geometry.toWorld(index);
    shown.normalLps =
        turned(region.normalLps, trueSteps(geometry, index.z), glm::dmat3(geometry.indexToWorld));
    return shown;
}

glm::dvec3 trueNormal(
    const VolumeGeometry& geometry, const glm::dvec3& shownLps, const glm::dvec3& normalLps)
{
    if (geometry.slicePositions.empty())
        return normalLps;
    return turned(normalLps, glm::dmat3(geometry.indexToWorld),
        trueSteps(geometry, geometry.toIndex(shownLps).z));
}

} // namespace core
