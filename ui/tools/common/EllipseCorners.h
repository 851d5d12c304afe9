// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace ui {

/// The corners of a polygon that stands for an ellipse along the axes, in any unit: so many that it
/// looks round at any size.
/// @param half its extent from the centre along each axis
[[nodiscard]] std::vector<glm::dvec2> ellipseCorners(
    const glm::dvec2& centre, const glm::dvec2& half);

} // namespace ui
