// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reenactment/BrushRobot.h"

namespace reenact {

/// Mends a mask with the tools of seed B alone: strokes over chunks while they explain the error,
/// then a surface and, region by region, whatever promises most for an action: sphere, plane, drag,
/// or red paint and a template; in the end it is written back.
///
/// An action is a stroke, a click, a contour, a button: dividing, each place of the slider, laying
/// the surface, writing back, and taking something back are actions, too. Radii are set with the
/// wheel, as the brush robot's are, and count as little.
struct SurfaceRobotTools {
    bool chunks = true; ///< else it begins with the surface
    int vertices = 12'000; ///< of the surface, about
};
[[nodiscard]] RobotRun runSurfaceRobot(RefinementBench& bench, const Truth& truth,
    const RobotGoal& goal, const SurfaceRobotTools& tools, std::uint64_t seed);

} // namespace reenact
