// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/BrushPath.h"
#include "tests/reenactment/RefinementBench.h"

#include <QStringList>

namespace reenact {

/// When a robot lays its pen down.
struct RobotGoal {
    double error = 2.7; ///< rVE against the voxelised organ, per cent
    int mostActions = 60;
};

/// What a robot came to.
struct RobotRun {
    Mask mask; ///< the segment in the end
    int actions = 0;
    int actionsToCommon = 0; ///< until rVE was 2.7 % or less; 0: it never was
    double seconds = 0.0; ///< of processors that the edits took
    QStringList log; ///< what it did, with rVE after it
};

/// Paints and erases with a brush alone, of the best radius for each region. A stroke is an action,
/// and so is taking one back that made it worse. It knows the whole of what a ball would do, beyond
/// the slice on which it is led, as nobody does who paints.
/// @param shape a disc paints the slice alone
[[nodiscard]] RobotRun runBrushRobot(RefinementBench& bench, const Truth& truth,
    const RobotGoal& goal, core::BrushPath::Shape shape, std::uint64_t seed);

} // namespace reenact
