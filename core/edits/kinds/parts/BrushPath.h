// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/PenPressures.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// The path of a brush: it covers everything within its radius of the path, which runs straight
/// from point to point. The radius may follow the pressure of a pen.
struct BrushPath {
    enum class Shape {
        Ball,
        Disc, ///< a circle in a plane, one voxel thick
        Square, ///< in a plane, one voxel thick
        Cube,
    };
    double radiusMm = 4.0; ///< of a square or cube: half of one side
    Shape shape = Shape::Ball;
    /// For a disc or square, the normal of its plane, which contains the first point; for a cube,
    /// the direction of a side.
    std::optional<glm::dvec3> normalLps{};
    /// For a square or cube, the direction of another side, about perpendicular to the normal.
    std::optional<glm::dvec3> sideLps{};
    std::vector<glm::dvec3> pointsLps{};
    /// Indices into pointsLps, ascending: the path does not lead to these points but begins anew
    /// there.
    std::vector<std::int64_t> lifts{};
    PenPressures pressures{};
};

/// Whether a brush of this shape lies in a plane.
[[nodiscard]] constexpr bool isFlat(BrushPath::Shape shape)
{
    return shape == BrushPath::Shape::Disc || shape == BrushPath::Shape::Square;
}

/// Whether it has corners.
[[nodiscard]] constexpr bool isSquare(BrushPath::Shape shape)
{
    return shape == BrushPath::Shape::Square || shape == BrushPath::Shape::Cube;
}

} // namespace core
