// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/outline/SliceLattice.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// The longest axis of a connected region in a slice, and the longest axis perpendicular to it, as
/// bidimensional tumour criteria measure them.
struct SegmentAxes {
    glm::dvec3 longFromLps{0.0};
    glm::dvec3 longToLps{0.0};
    glm::dvec3 shortFromLps{0.0};
    glm::dvec3 shortToLps{0.0};
};

/// Measures the region of pixels that is connected with a pixel by sides or corners. It is
/// represented by the convex hull of the midpoints of its pixels' sides; so the diameter of a disc
/// is right to within a pixel, and on average exactly. The long axis joins the two corners of the
/// hull that lie farthest apart (the first pair found, if several do). The short axis is the
/// longest chord of the hull that is perpendicular to it. Either may leave the region where it is
/// concave.
///
/// Where slices are unevenly spaced, both axes are those of the true places (truePlace()): the long
/// one joins the two midpoints that truly lie farthest apart, and the short one is perpendicular to
/// it in the patient. Their ends are given where the slice shows them.
///
/// @param geometry of the volume
/// @param inside for each pixel, x fastest; 0 is outside
/// @return none: the pixel is outside
[[nodiscard]] std::optional<SegmentAxes> segmentAxes(const SliceLattice& lattice,
    const VolumeGeometry& geometry, const std::vector<std::uint8_t>& inside,
    const glm::ivec2& pixel);

} // namespace core
