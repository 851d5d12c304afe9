// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace core {

/// A place of a segment that may need a look.
struct DoubtfulPlace {
    enum class Why : std::uint8_t {
        NoEdge, ///< the segment ends where the values hardly change
        OnlyHere, ///< the segment has what a second mask does not have
        OnlyThere, ///< the second mask has what the segment does not have
    };
    Why why = Why::NoEdge;
    glm::ivec3 voxel{0}; ///< about in its middle, and one of its own
    glm::dvec3 placeLps{0.0}; ///< the centre of that voxel
    double areaMm2 = 0.0; ///< of the border, for NoEdge
    double volumeMm3 = 0.0; ///< for the others
    bool operator==(const DoubtfulPlace&) const = default;
};

} // namespace core
