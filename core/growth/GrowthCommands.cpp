// SPDX-License-Identifier: Apache-2.0
#include "core/growth/GrowthCommands.h"

namespace core {

bool isSound(const GrowLimits& limits)
{
    const auto between = [](int value, int low, int high) { return value >= low && value <= high; };
    for (int axis = 0; axis < 3; ++axis) {
        if (!between(limits.gradientWeights[axis], 0, 65535))
            return false;
    }
    return limits.difference.value_or(0) >= 0 && limits.gradient.value_or(0) >= 0
        && limits.gradientDifference.value_or(0) >= 0 && between(limits.majority, 0, 27)
        && between(limits.sigmas256, 0, 25600) && isSound(limits.passage);
}

bool isSound(const GrowBurst& burst)
{
    const bool rolls = isAsked(burst.limits.passage);
    return isSound(burst.limits) && isSound(burst.seedGroups)
        && (!rolls || (burst.opening != GrowOpening::Narrow && burst.tellsHeld));
}

bool isSound(const ShutListed& edit, int brickCount)
{
    std::int64_t last = -1;
    for (const ShutListed::Brick& brick : edit.bricks) {
        if (std::int64_t(brick.brick) <= last || std::int64_t(brick.brick) >= brickCount)
            return false;
        last = brick.brick;
    }
    return true;
}

} // namespace core
