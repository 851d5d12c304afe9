// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/SliceDistances.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// A connected part of what is drawn in a slice; pixels that touch only at a corner are connected.
struct SlicePart {
    glm::ivec2 begin{0}; ///< first corner of the rectangle around it
    glm::ivec2 end{0}; ///< one beyond its last corner
    glm::ivec2 centroid{0}; ///< rounded to a pixel, which need not be its own
    /// Its own pixel nearest to the centroid; of equally near ones the first in memory.
    glm::ivec2 middle{0};
};

/// The parts of what is drawn in a slice, in the order of their first pixels.
struct SliceParts {
    glm::ivec2 size{0};
    /// For each pixel, the index of its part; negative: nothing is drawn there.
    std::vector<int> partAt{};
    std::vector<SlicePart> parts{};
};
[[nodiscard]] SliceParts sliceParts(const SliceMask& mask, const SliceSteps& steps);

/// Parts of two slices that show the same structure, as indices; one of the lists may be empty.
struct MatchedParts {
    std::vector<int> lower{};
    std::vector<int> upper{};
    bool overlap = false; ///< whether parts of both slices share pixels
};
/// Assigns every part of either slice to exactly one MatchedParts. Parts that overlap belong
/// together, also indirectly: a structure that divides, or two that join. A part that overlaps none
/// belongs to the part of the other slice whose centroid is nearest, if that one overlaps none
/// either and has this part as its nearest, too (of equally near ones the first counts). Any other
/// part ends between the slices.
[[nodiscard]] std::vector<MatchedParts> matchedParts(
    const SliceParts& lower, const SliceParts& upper, const SliceSteps& steps);

} // namespace core
