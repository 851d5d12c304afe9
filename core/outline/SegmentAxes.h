// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/outline/SliceLattice.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// The longest axis of what hangs together in a slice, and the longest one across it: what
/// bidimensional criteria of tumours measure.
struct SegmentAxes {
    glm::dvec3 longFromLps{0.0};
    glm::dvec3 longToLps{0.0};
    glm::dvec3 shortFromLps{0.0};
    glm::dvec3 shortToLps{0.0};
};

/// The pixels that hang together with one, at sides or corners, are taken as the convex hull of the
/// middles of their sides: so a disc has its diameter to within a pixel, on average exactly. The
/// long axis joins its two corners that lie farthest apart (the first found of several); the short
/// one is the longest chord of the hull that is perpendicular to it. Either may leave the pixels
/// where they form a dent.
///
/// @param inside by pixel, x fastest: 0 is outside
/// @return none: the pixel is outside
[[nodiscard]] std::optional<SegmentAxes> segmentAxes(
    const SliceLattice& lattice, const std::vector<std::uint8_t>& inside, const glm::ivec2& pixel);

} // namespace core
