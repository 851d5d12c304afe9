// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"
#include "tests/reenactment/CounterRandom.h"

#include <vector>

namespace reenact {

/// A hand that trembles by 1 mm (root of the mean square), whatever it holds.
class PenHand {
public:
    static constexpr double jitterMm = 1.0;
    /// A hand trembles slowly: points of a stroke that are nearer than this go astray alike.
    static constexpr double alikeMm = 4.0;

    PenHand(const core::VolumeGeometry& geometry, std::uint64_t seed);

    /// Where a stroke or a click goes that is meant to go there: off by jitterMm along each axis,
    /// but never off the picture.
    [[nodiscard]] std::vector<glm::dvec3> drawn(const std::vector<glm::dvec3>& lps);
    /// The same on a plane, which the pen does not leave.
    [[nodiscard]] std::vector<glm::dvec3> drawnOnPlane(
        const std::vector<glm::dvec3>& lps, const glm::dvec3& normalLps);
    /// Set with a wheel, by eye: off by jitterMm, no less than 1 mm.
    [[nodiscard]] double radiusMm(double meantMm);
    /// Turned so that the rim of what is held, so far from its middle, goes astray by jitterMm.
    [[nodiscard]] glm::dvec3 normal(const glm::dvec3& meantLps, double radiusMm);

    /// Index places as LPS.
    [[nodiscard]] std::vector<glm::dvec3> lps(const std::vector<glm::dvec3>& index) const;
    [[nodiscard]] double mm(double voxels) const { return voxels * m_voxelMm; }

private:
    [[nodiscard]] glm::dvec3 shake();

    core::VolumeGeometry m_geometry;
    glm::dmat4 m_toIndex;
    double m_voxelMm;
    CounterRandom m_random;
};

} // namespace reenact
