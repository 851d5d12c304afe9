// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace core {

/// A distance between two points of the patient, wherever they are shown: of a piece that is moved
/// or zoomed it is the true one.
struct Measurement {
    int id = 0; ///< 1, 2, 3 …, unique and never used again
    glm::dvec3 fromLps{0.0};
    glm::dvec3 toLps{0.0};
    int piece = 0; ///< the piece that both points were picked on, and move with in 3D; 0: none

    [[nodiscard]] double lengthMm() const { return glm::distance(fromLps, toLps); }
    bool operator==(const Measurement&) const = default;
};

} // namespace core
