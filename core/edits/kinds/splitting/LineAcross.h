// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

// A line that was drawn across a picture to cut it in two: beyond its ends it goes on straight. All
// places are of one plane in any unit; y may point upwards or downwards.

/// In which directions a line goes on; both have the length 1.
struct LineEnds {
    glm::dvec2 before{0.0}; ///< from its first point
    glm::dvec2 behind{0.0}; ///< from its last point
};

/// Finds them. The direction at an end is that from the place on the line which is a tenth of its
/// length away, so that it hardly depends on how a pen was set down and lifted. None: the line has
/// no length, or comes back to an end within that tenth.
[[nodiscard]] std::optional<LineEnds> lineEnds(const std::vector<glm::dvec2>& line);

/// The area of a rectangle on one side of a line, as a closed curve: the line itself, what it goes
/// on to at both ends up to the border of the rectangle, and that border. It is the side on the
/// left of one who follows the line, if y points upwards.
/// @param low, high corners of the rectangle, within which all points of the line lie
/// Empty if the line has no ends (lineEnds()).
[[nodiscard]] std::vector<glm::dvec2> leftOfLine(
    const std::vector<glm::dvec2>& line, const glm::dvec2& low, const glm::dvec2& high);

} // namespace core
