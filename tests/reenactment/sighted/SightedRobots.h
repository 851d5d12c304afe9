// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reenactment/sighted/SightedLog.h"

namespace reenact {

/// When a robot lays its pen down at the latest. Before that it does so as soon as it sees nothing
/// that is worth another action.
struct SightedPatience {
    int mostActions = 12;
};

/// Mends a mask with the tools of seed B: strokes over chunks while they explain what is wrong,
/// then a surface and, region by region, what promises most for an action: sphere, plane, drag,
/// attraction, or red paint and a template; in the end it is written back. Dividing, each place of
/// the slider, laying, writing back, each contour and taking something back are actions, too; radii
/// are set with the wheel and are not.
/// @param reader its looks are all that the robot learns of the organ
[[nodiscard]] SightedRun runSightedSurfaceRobot(
    RefinementBench& bench, Reader& reader, const SightedPatience& patience, std::uint64_t seed);

/// Paints and erases with a ball alone, on slices, by the same sight and with the same hand.
[[nodiscard]] SightedRun runSightedBrushRobot(
    RefinementBench& bench, Reader& reader, const SightedPatience& patience, std::uint64_t seed);

} // namespace reenact
