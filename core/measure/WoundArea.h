// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace core {

// The inside of a closed outline that may cross itself: everything that it winds around, as for an
// outline that fills a segment (core/edits/kinds/segments/FillOutline.h).

/// The four corners, in order around it.
using Trapezoid = std::array<glm::dvec2, 4>;

/// Divides the inside into trapezoids with two sides parallel to x, which share at most their
/// borders. Cost ∝ (corners + crossings) × corners.
[[nodiscard]] std::vector<Trapezoid> woundTrapezoids(const std::vector<glm::dvec2>& polygon);

/// The area of the inside.
[[nodiscard]] double woundArea(const std::vector<glm::dvec2>& polygon);

/// Whether a place lies inside or on the outline.
[[nodiscard]] bool isWound(const std::vector<glm::dvec2>& polygon, const glm::dvec2& place);

} // namespace core
