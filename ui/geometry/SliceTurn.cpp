// SPDX-License-Identifier: Apache-2.0
#include "ui/geometry/SliceTurn.h"

namespace ui {

SliceAxes SliceTurn::of(const SliceAxes& upright) const
{
    SliceAxes axes = upright;
    if (mirrored) {
        axes.rightLps = -axes.rightLps;
        axes.normalLps = -axes.normalLps;
    }
    // What was on the right goes to the bottom, and what was at the bottom to the left.
    for (int turn = 0; turn < quarters; ++turn)
        axes = {-axes.downLps, axes.rightLps, axes.normalLps};
    return axes;
}

SliceTurn SliceTurn::flippedLeftRight() const
{
    // To turn and then to flip is to flip and then to turn back.
    return {!mirrored, (4 - quarters) % 4};
}

SliceTurn SliceTurn::flippedTopBottom() const
{
    // A half turn exchanges all four sides.
    const SliceTurn flipped = flippedLeftRight();
    return {flipped.mirrored, (flipped.quarters + 2) % 4};
}

SliceTurn SliceTurn::turnedClockwise() const
{
    return {mirrored, (quarters + 1) % 4};
}

} // namespace ui
