// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/PenPressures.h"
#include "core/edits/kinds/surface/parts/SurfaceRules.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// The path of a tool of the surface: the centre of the ball in which it works, from point to
/// point.
struct SurfacePath {
    double radiusMm = 8.0;
    std::vector<glm::dvec3> pointsLps{};
    SurfaceRules rules{};
    PenPressures pressures{};
};

} // namespace core
