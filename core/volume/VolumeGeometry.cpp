// SPDX-License-Identifier: Apache-2.0
#include "core/volume/VolumeGeometry.h"

#include <algorithm>
#include <cmath>

namespace core {

glm::dmat4 VolumeGeometry::worldToIndex() const
{
    return glm::inverse(indexToWorld);
}

glm::dvec3 VolumeGeometry::toWorld(const glm::dvec3& index) const
{
    return glm::dvec3(indexToWorld * glm::dvec4(index, 1.0));
}

glm::dvec3 VolumeGeometry::toIndex(const glm::dvec3& worldLps) const
{
    return glm::dvec3(worldToIndex() * glm::dvec4(worldLps, 1.0));
}

glm::dvec3 VolumeGeometry::spacingMm() const
{
    return {glm::length(glm::dvec3(indexToWorld[0])), glm::length(glm::dvec3(indexToWorld[1])),
        glm::length(glm::dvec3(indexToWorld[2]))};
}

glm::dmat3 VolumeGeometry::direction() const
{
    const glm::dvec3 spacing = spacingMm();
    return {glm::dvec3(indexToWorld[0]) / spacing.x, glm::dvec3(indexToWorld[1]) / spacing.y,
        glm::dvec3(indexToWorld[2]) / spacing.z};
}

double VolumeGeometry::voxelVolumeMm3() const
{
    return std::abs(glm::determinant(glm::dmat3(indexToWorld)));
}

double VolumeGeometry::shearAngleDegrees() const
{
    const glm::dmat3 axes = direction();
    const double along = std::abs(glm::dot(glm::normalize(glm::cross(axes[0], axes[1])), axes[2]));
    return glm::degrees(std::acos(std::clamp(along, 0.0, 1.0)));
}

std::size_t VolumeGeometry::voxelCount() const
{
    return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
}

bool VolumeGeometry::contains(const glm::ivec3& index) const
{
    return index.x >= 0 && index.y >= 0 && index.z >= 0 && index.x < size.x && index.y < size.y
        && index.z < size.z;
}

std::vector<glm::dvec3> VolumeGeometry::cornersLps() const
{
    std::vector<glm::dvec3> corners;
    for (int corner = 0; corner < 8; ++corner) {
        corners.push_back(toWorld({(corner & 1) ? size.x - 0.5 : -0.5,
            (corner & 2) ? size.y - 0.5 : -0.5, (corner & 4) ? size.z - 0.5 : -0.5}));
    }
    return corners;
}

double evenSlicesToleranceMm(double stepMm)
{
    constexpr double mostMm = 0.01;
    constexpr double share = 0.01;
    return std::min(mostMm, share * stepMm);
}

} // namespace core
