// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/MaskFrame.h"

#include <algorithm>
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

MaskColumn restoringColumn(
    const MaskFrame& frame, const SurfaceHit& hit, std::int32_t from, std::int32_t weight)
{
    const std::int32_t r = frame.rampHalfWidth;
    const std::int32_t lastVoxel = (frame.front >> 1) + r;
    from = std::min(from, hit.zSurface - lastVoxel);
    const bool all = from - hit.zExit <= frame.front - (r >> 3);
    if (all)
        from = hit.zExit - 2 * frame.front - 2 * r;
    return {from, hit.zSurface + lastVoxel, weight};
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
