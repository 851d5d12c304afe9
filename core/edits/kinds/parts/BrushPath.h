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
    };
    double radiusMm = 4.0;
    Shape shape = Shape::Ball;
    std::optional<glm::dvec3> normalLps{}; ///< of a disc's plane, which contains the first point
    std::vector<glm::dvec3> pointsLps{};
    /// Indices into pointsLps, ascending: the path does not lead to these points but begins anew
    /// there.
    std::vector<std::int64_t> lifts{};
    PenPressures pressures{};
};

} // namespace core
