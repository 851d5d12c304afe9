// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/MaskFrame.h"

#include <cmath>

namespace core {

std::int64_t fixedPoint::squareRoot(std::int64_t value)
{
    auto root = std::int64_t(std::sqrt(double(value)));
    while (root * root > value)
        --root;
    while ((root + 1) * (root + 1) <= value)
        ++root;
    return root;
}

glm::ivec3 planeBase(const MaskFrame& frame, const glm::ivec3& firstVoxel)
{
    glm::ivec3 base;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = std::size_t(axis);
        base[axis] =
            int(fixedPoint::round14(frame.planeOrigin[i] + firstVoxel.x * frame.planePerI[i]
                + firstVoxel.y * frame.planePerJ[i] + firstVoxel.z * frame.planePerK[i]));
    }
    return base;
}

} // namespace core
