// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace core {

/// A place where a segment may be wrong, so that a user should look at it.
struct DoubtfulPlace {
    enum class Why : std::uint8_t {
        NoEdge, ///< the segment's border lies where the values hardly change
        OnlyHere, ///< the segment contains a part that a second mask does not contain
        OnlyThere, ///< the second mask contains a part that the segment does not contain
    };
    Why why = Why::NoEdge;
    glm::ivec3 voxel{0}; ///< a voxel of the place, near its centroid
    glm::dvec3 placeLps{0.0}; ///< the centre of that voxel
    double areaMm2 = 0.0; ///< area of this part of the border; only for NoEdge
    double volumeMm3 = 0.0; ///< volume of the part; only for the other two
    bool operator==(const DoubtfulPlace&) const = default;
};

} // namespace core
