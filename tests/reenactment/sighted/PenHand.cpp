// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/sighted/PenHand.h"

#include "tests/reenactment/lobes/PlaneOutlines.h"

#include <algorithm>
#include <cmath>

namespace reenact {

PenHand::PenHand(const core::VolumeGeometry& geometry, std::uint64_t seed)
    : m_geometry(geometry)
    , m_toIndex(geometry.worldToIndex())
    , m_voxelMm(std::cbrt(geometry.voxelVolumeMm3()))
    , m_random(seed, 202)
{
}

glm::dvec3 PenHand::shake()
{
    const double x = m_random.normal();
    const double y = m_random.normal();
    return {x, y, m_random.normal()};
}

std::vector<glm::dvec3> PenHand::drawn(const std::vector<glm::dvec3>& lps)
{
    return drawnOnPlane(lps, glm::dvec3(0.0));
}

std::vector<glm::dvec3> PenHand::drawnOnPlane(
    const std::vector<glm::dvec3>& lps, const glm::dvec3& normalLps)
{
    const glm::dvec3 most(m_geometry.size - 1);
    std::vector<glm::dvec3> places;
    glm::dvec3 off = jitterMm * shake();
    for (std::size_t i = 0; i < lps.size(); ++i) {
        if (i > 0) {
            const double away = glm::distance(lps[i - 1], lps[i]) / alikeMm;
            const double alike = std::exp(-0.5 * away * away);
            off = alike * off + jitterMm * std::sqrt(1.0 - alike * alike) * shake();
        }
        const glm::dvec3 flat = off - glm::dot(off, normalLps) * normalLps;
        const glm::dvec3 index(m_toIndex * glm::dvec4(lps[i] + flat, 1.0));
        places.push_back(m_geometry.toWorld(glm::clamp(index, glm::dvec3(0.0), most)));
    }
    return places;
}

double PenHand::radiusMm(double meantMm)
{
    return std::max(1.0, meantMm + jitterMm * m_random.normal());
}

glm::dvec3 PenHand::normal(const glm::dvec3& meantLps, double radiusMm)
{
    const glm::dvec3 along = axisBeside(meantLps);
    const glm::dvec3 beside = glm::cross(meantLps, along);
    const double turn = jitterMm / radiusMm;
    const double one = m_random.normal();
    return glm::normalize(meantLps + turn * one * along + turn * m_random.normal() * beside);
}

std::vector<glm::dvec3> PenHand::lps(const std::vector<glm::dvec3>& index) const
{
    std::vector<glm::dvec3> places;
    for (const glm::dvec3& place : index)
        places.push_back(m_geometry.toWorld(place));
    return places;
}

} // namespace reenact
