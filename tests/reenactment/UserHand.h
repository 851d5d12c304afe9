// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"
#include "tests/reenactment/CounterRandom.h"

#include <vector>

namespace reenact {

/// A hand that means a place and points somewhere near it.
class UserHand {
public:
    static constexpr double jitterVoxels = 0.7; ///< deviation along each axis, of every point
    static constexpr double misplacedShare = 0.1; ///< of all strokes, clicks and contours
    static constexpr double misplacedVoxels = 3.0; ///< so far off as a whole, any way

    UserHand(const core::VolumeGeometry& geometry, std::uint64_t seed);

    /// Where a stroke, a click or a contour goes that is meant to go there. @param index places
    [[nodiscard]] std::vector<glm::dvec3> drawn(const std::vector<glm::dvec3>& index);
    /// The same on a plane, which the pen does not leave. @param normal of it, index axes
    [[nodiscard]] std::vector<glm::dvec3> drawnOnPlane(
        const std::vector<glm::dvec3>& index, const glm::dvec3& normal);

    /// Index places as LPS.
    [[nodiscard]] std::vector<glm::dvec3> lps(const std::vector<glm::dvec3>& index) const;
    [[nodiscard]] double mm(double voxels) const { return voxels * m_voxelMm; }

private:
    const core::VolumeGeometry& m_geometry;
    double m_voxelMm;
    CounterRandom m_random;
};

} // namespace reenact
