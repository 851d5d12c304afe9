// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/IntegerHalfSpace.h"

#include <algorithm>
#include <cstdlib>

namespace core {

namespace {

std::int64_t dot(const glm::ivec3& a, const glm::ivec3& b)
{
    return std::int64_t(a.x) * b.x + std::int64_t(a.y) * b.y + std::int64_t(a.z) * b.z;
}

std::int64_t floorOf(std::int64_t value, std::int64_t divisor)
{
    return value >= 0 ? value / divisor : -((-value + divisor - 1) / divisor);
}

} // namespace

bool isSound(const std::vector<IntegerHalfSpace>& hidden)
{
    return hidden.size() <= 16
        && std::all_of(hidden.begin(), hidden.end(), [](const IntegerHalfSpace& half) {
               const glm::ivec3 size = glm::abs(half.perVoxel);
               return std::max({size.x, size.y, size.z}) <= 1 << 20
                   && std::abs(half.offset) <= std::int64_t(1) << 40;
           });
}

SeenSamples seenSamples(const std::vector<IntegerHalfSpace>& hidden, const glm::ivec3& origin,
    const glm::ivec3& step, int count)
{
    std::int64_t first = 0;
    std::int64_t end = count;
    for (const IntegerHalfSpace& half : hidden) {
        // Seen while start + n · perSample ≤ 0.
        const std::int64_t start = dot(half.perVoxel, origin) - half.offset * 65536;
        const std::int64_t perSample = dot(half.perVoxel, step);
        if (perSample > 0)
            end = std::min(end, floorOf(-start, perSample) + 1);
        else if (perSample < 0)
            first = std::max(first, -floorOf(-start, -perSample));
        else if (start > 0)
            end = 0;
    }
    if (first >= end)
        return {};
    return {int(first), int(end)};
}

SeenSamples samplesWithin(const SeenSamples& samples, const glm::ivec3& origin,
    const glm::ivec3& step, const VoxelBox& box)
{
    std::int64_t first = samples.first;
    std::int64_t end = samples.end;
    for (int axis = 0; axis < 3; ++axis) {
        // Within these, both ends included, the nearest voxel is one of the box.
        const std::int64_t low = (2 * std::int64_t(box.minimum[axis]) - 1) * 32768 - origin[axis];
        const std::int64_t high =
            (2 * std::int64_t(box.maximum[axis]) - 1) * 32768 - 1 - origin[axis];
        if (step[axis] == 0) {
            if (low > 0 || high < 0)
                return {};
            continue;
        }
        const std::int64_t from = step[axis] > 0 ? low : -high;
        const std::int64_t to = step[axis] > 0 ? high : -low;
        const std::int64_t stride = std::abs(step[axis]);
        first = std::max(first, -floorOf(-from, stride));
        end = std::min(end, floorOf(to, stride) + 1);
    }
    if (first >= end)
        return {};
    return {int(first), int(end)};
}

std::vector<std::int32_t> hiddenBase(
    const std::vector<IntegerHalfSpace>& hidden, const glm::ivec3& firstVoxel)
{
    constexpr std::int64_t far = std::int64_t(1) << 30;
    std::vector<std::int32_t> base;
    for (const IntegerHalfSpace& half : hidden)
        base.push_back(
            std::int32_t(std::clamp(dot(half.perVoxel, firstVoxel) - half.offset, -far, far)));
    return base;
}

} // namespace core
