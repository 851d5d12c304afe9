// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// Where a brush went: all that lies within its radius of the path, which runs straight from point
/// to point.
struct BrushPath {
    enum class Shape {
        Ball,
        Disc, ///< round in a plane, one voxel thick
    };
    double radiusMm = 4.0;
    Shape shape = Shape::Ball;
    std::optional<glm::dvec3> normalLps{}; ///< of a disc's plane, which holds the first point
    std::vector<glm::dvec3> pointsLps{};
    /// Places in pointsLps, ascending: the path does not run to these points but begins anew there.
    std::vector<std::int64_t> lifts{};
};

} // namespace core
