// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace ui {

/// Returns a polygon of 256 corners that stands for an ellipse along the axes, in any unit. It
/// looks round at any usual size.
/// @param half semi-axes of the ellipse along x and y
[[nodiscard]] std::vector<glm::dvec2> ellipseCorners(
    const glm::dvec2& centre, const glm::dvec2& half);

} // namespace ui
