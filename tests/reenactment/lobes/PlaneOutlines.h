// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <functional>
#include <vector>

namespace reenact {

/// A plane across a volume, as wide as that.
struct CuttingPlane {
    glm::dvec3 middleLps{0.0};
    glm::dvec3 rightLps{1.0, 0.0, 0.0};
    glm::dvec3 downLps{0.0, 1.0, 0.0};
    double halfMm = 0.0; ///< it reaches so far to either side, along both

    [[nodiscard]] static CuttingPlane through(const core::VolumeGeometry& geometry,
        const glm::dvec3& placeLps, const glm::dvec3& normalLps);
    [[nodiscard]] glm::dvec3 normalLps() const { return glm::cross(rightLps, downLps); }
};

/// A unit vector across another one.
[[nodiscard]] glm::dvec3 axisBeside(const glm::dvec3& normal);

/// Places in LPS, mm.
using PlaneLine = std::vector<glm::dvec3>;

/// Where a function of places changes its sign on a plane, by cells of @p stepMm. The lines close,
/// as long as it is negative at the plane's rim.
[[nodiscard]] std::vector<PlaneLine> outlinesOn(const CuttingPlane& plane, double stepMm,
    const std::function<double(const glm::dvec3& placeLps)>& valueAt);

} // namespace reenact
