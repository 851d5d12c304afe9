// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// The outline of a tool's tip, in the view plane (seed A §4.1).
struct ToolMask {
    enum class Kind : std::uint8_t { Circle, Ellipse, Square, Rectangle, Rounded };
    Kind kind = Kind::Circle; ///< not used if there is a polygon
    double radiusMm = 8.0; ///< circle
    double widthMm = 16.0; ///< all others; for a square both sides
    double heightMm = 16.0;
    double cornerMm = 2.0; ///< rounded: radius of the corners
    double rotationDegrees = 0.0; ///< counter-clockwise
    /// The depth rises to its full value over this distance from the edge inwards; 0: a sharp edge.
    double softnessMm = 0.0;
    /// Closed from the last point to the first; may cross itself; relative to the sample.
    std::optional<std::vector<glm::dvec2>> polygonMm{};
    bool operator==(const ToolMask&) const = default;
};

} // namespace core
