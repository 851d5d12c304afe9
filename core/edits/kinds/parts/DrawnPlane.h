// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace core {

/// A plane of any direction on which something was drawn, one voxel thick.
struct DrawnPlane {
    glm::dvec3 placeLps{0.0}; ///< a place in it
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< a direction perpendicular to it
    bool operator==(const DrawnPlane&) const = default;
};

} // namespace core
