// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reenactment/lobes/PlaneOutlines.h"

namespace reenact {

/// What somebody sees who looks at a cutting plane: all that a sighted robot ever learns.
struct SeenPlane {
    CuttingPlane plane;
    /// Grey values, row by row, `greyStepMm` apart; the middle one is at the plane's middle.
    std::vector<float> grey;
    double greyStepMm = 2.0;
    int greyHalf = 0; ///< so many to either side of the middle
    std::vector<PlaneLine> contours; ///< of the mask or the surface, as the program draws it
    /// Where the reader takes the organ's border to be: nobody has drawn it.
    std::vector<PlaneLine> readings;

    /// Of the nearest sample; beyond the rim as at it.
    [[nodiscard]] double greyAt(const glm::dvec3& placeLps) const;
};

/// Of the points of the readings near some places, which share lies on an edge of the grey values:
/// the mean on one side differs from that on the other by more than the noise would. 0: there are
/// no such points. @param isNear of a place, LPS
[[nodiscard]] double edgeShare(
    const SeenPlane& view, const std::function<bool(const glm::dvec3& placeLps)>& isNear);

} // namespace reenact
