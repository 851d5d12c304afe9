// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/SliceDistances.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// Pixels of a slice that touch each other, be it at a corner.
struct SlicePart {
    glm::ivec2 begin{0}; ///< of the rectangle around it
    glm::ivec2 end{0}; ///< one beyond
    glm::ivec2 centroid{0}; ///< rounded to a pixel, which need not be its own
    glm::ivec2 middle{0}; ///< its own pixel nearest to that; of equal ones the first in memory
};

/// The parts of what is drawn in a slice, in the order of their first pixels.
struct SliceParts {
    glm::ivec2 size{0};
    std::vector<int> partAt{}; ///< of each pixel; less than 0: nothing is drawn there
    std::vector<SlicePart> parts{};
};
[[nodiscard]] SliceParts sliceParts(const SliceMask& mask, const SliceSteps& steps);

/// Parts of two slices that are the same thing; one of the lists may be empty.
struct MatchedParts {
    std::vector<int> lower{};
    std::vector<int> upper{};
    bool overlap = false; ///< laid over each other they share pixels
};
/// Each part of either slice in one of them. What overlaps belongs together, also by way of others:
/// a thing that divides, or two that join. A part that overlaps none belongs to the one whose
/// centroid is nearest among all of the other slice, if that overlaps none either and finds it the
/// nearest, too (of equally near ones the first counts). Any other one ends between the slices.
[[nodiscard]] std::vector<MatchedParts> matchedParts(
    const SliceParts& lower, const SliceParts& upper, const SliceSteps& steps);

} // namespace core
