// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reenactment/OrganScenes.h"

#include <array>

namespace reenact {

/// A row of the paper's Table 1 (seed B, section 7.3). The scan has 153 and 41 % in rows 1a and 4;
/// 15.3 and 4.1 % are what fits the other rows.
struct TableRow {
    enum class Fault : std::uint8_t {
        Bump, ///< an uneven layer too much over an end of the organ
        Cut, ///< an end is missing, unevenly
        Leak, ///< through a neck into a neighbour, as far as an uneven front has run there
    };
    const char* number = "";
    const char* text = "";
    Organ organ = Organ::None;
    Fault fault = Fault::Bump;
    Organ into = Organ::None; ///< of a leak
    glm::dvec3 towards{0.0}; ///< LPS: where the fault is, about, seen from the organ's middle
    double before = 0.0; ///< rVE, per cent
    double after = 0.0;
    double minutes = 0.0;
};
[[nodiscard]] const std::array<TableRow, 8>& tableRows();

/// A mask as a poor segmentation would leave it.
struct Corrupted {
    Mask mask;
    double error = 0.0; ///< rVE against the organ, per cent
    double jitter = 0.0; ///< what of it the border's jitter alone makes
};

/// Spoils an organ: place, shape and size of the fault are drawn by the seed, its size is bisected
/// until the row's first error is met within 0.1 percentage points; before that, smooth noise
/// moves the border in and out so that a fifth of the row's second error comes of that alone.
/// @param scale of lengths, as that of the scene; necks are 2 to 4 voxels in radius at 1
[[nodiscard]] Corrupted corrupted(
    const OrganScene& scene, const TableRow& row, double scale, std::uint64_t seed);

} // namespace reenact
