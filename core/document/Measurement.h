// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace core {

/// A distance between two points of the patient. It is the true one even if the points are shown
/// elsewhere, on a piece that was moved or zoomed.
struct Measurement {
    int id = 0; ///< 1, 2, 3 …, unique and never used again
    glm::dvec3 fromLps{0.0};
    glm::dvec3 toLps{0.0};
    /// the piece on which both points were picked and with which they move in 3D; 0: none
    int piece = 0;

    [[nodiscard]] double lengthMm() const { return glm::distance(fromLps, toLps); }
    bool operator==(const Measurement&) const = default;
};

} // namespace core
