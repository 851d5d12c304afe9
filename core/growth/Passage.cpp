// SPDX-License-Identifier: Apache-2.0
#include "core/growth/Passage.h"

#include <algorithm>

namespace core {

namespace {

constexpr int greatestSquare = 65534; // 65535 is nowhere
constexpr int greatestSpacing = 256;

} // namespace

glm::ivec3 reachOf(const Passage& passage)
{
    glm::ivec3 voxels(0);
    for (int axis = 0; axis < 3; ++axis) {
        const int spacing = passage.spacing[axis];
        const auto reaches = [&](int steps) {
            return spacing * spacing * steps * steps <= passage.reach;
        };
        while (spacing > 0 && voxels[axis] < greatestPassageReach && reaches(voxels[axis] + 1))
            ++voxels[axis];
    }
    return voxels;
}

bool isAsked(const Passage& passage)
{
    return reachOf(passage) != glm::ivec3(0);
}

bool isSound(const Passage& passage)
{
    if (passage.reach == 0)
        return true;
    if (passage.reach < 0 || passage.reach > greatestSquare)
        return false;
    for (int axis = 0; axis < 3; ++axis) {
        const int spacing = passage.spacing[axis];
        if (spacing < 1 || spacing > greatestSpacing)
            return false;
        const int beyond = spacing * (greatestPassageReach + 1);
        if (beyond * beyond <= passage.reach)
            return false;
    }
    return true;
}

} // namespace core
