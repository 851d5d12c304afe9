// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/UserHand.h"

#include <cmath>

namespace reenact {

UserHand::UserHand(const core::VolumeGeometry& geometry, std::uint64_t seed)
    : m_geometry(geometry)
    , m_voxelMm(std::cbrt(geometry.voxelVolumeMm3()))
    , m_random(seed, 101)
{
}

std::vector<glm::dvec3> UserHand::drawn(const std::vector<glm::dvec3>& index)
{
    return drawnOnPlane(index, glm::dvec3(0.0));
}

std::vector<glm::dvec3> UserHand::drawnOnPlane(
    const std::vector<glm::dvec3>& index, const glm::dvec3& normal)
{
    const auto flat = [&normal](
                          const glm::dvec3& way) { return way - glm::dot(way, normal) * normal; };
    const bool isMisplaced = m_random.unit() < misplacedShare;
    const glm::dvec3 way = m_random.direction();
    const glm::dvec3 off = isMisplaced ? misplacedVoxels * flat(way) : glm::dvec3(0.0);
    std::vector<glm::dvec3> places;
    for (const glm::dvec3& place : index) {
        const glm::dvec3 shaken(m_random.normal(), m_random.normal(), m_random.normal());
        places.push_back(place + off + jitterVoxels * flat(shaken));
    }
    return places;
}

std::vector<glm::dvec3> UserHand::lps(const std::vector<glm::dvec3>& index) const
{
    std::vector<glm::dvec3> places;
    for (const glm::dvec3& place : index)
        places.push_back(m_geometry.toWorld(place));
    return places;
}

} // namespace reenact
