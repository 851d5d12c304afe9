// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace core {

// What a closed outline encloses that may cross itself: whatever it winds around, as an outline
// that fills a segment does (core/edits/kinds/segments/FillOutline.h).

/// Corners, in order.
using Trapezoid = std::array<glm::dvec2, 4>;

/// Divides the inside into trapezoids with two sides along x, which share no more than their
/// borders. The cost is that of the corners and crossings times the corners.
[[nodiscard]] std::vector<Trapezoid> woundTrapezoids(const std::vector<glm::dvec2>& polygon);

/// The area of the inside.
[[nodiscard]] double woundArea(const std::vector<glm::dvec2>& polygon);

/// Whether a place lies inside or on the outline.
[[nodiscard]] bool isWound(const std::vector<glm::dvec2>& polygon, const glm::dvec2& place);

} // namespace core
