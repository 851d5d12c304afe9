// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/DrillCut.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

std::int64_t integerSquareRoot(std::int64_t value)
{
    auto root = std::int64_t(std::sqrt(double(value)));
    while (root * root > value)
        --root;
    while ((root + 1) * (root + 1) <= value)
        ++root;
    return root;
}

std::int32_t floorDivide(std::int64_t value, std::int32_t divisor)
{
    return std::int32_t(value >= 0 ? value / divisor : -((-value + divisor - 1) / divisor));
}

} // namespace

std::int32_t elementDepth(
    const DrillFrame& frame, const DrillSample& sample, const glm::ivec2& element)
{
    const std::int64_t pitch = frame.pitch;
    const std::int64_t dx = element.x * pitch + pitch / 2 - sample.x;
    const std::int64_t dy = element.y * pitch + pitch / 2 - sample.y;
    const std::int64_t distance = integerSquareRoot(dx * dx + dy * dy);
    const std::int64_t scaled = (frame.maskRadius - distance) * 256 + 128 * pitch;
    if (scaled <= 0)
        return 0;
    const std::int64_t mask = std::min<std::int64_t>(scaled / pitch, 256);
    return std::int32_t((sample.depth * mask) >> 8);
}

ElementBox elementsUnder(const DrillFrame& frame, const DrillSample& sample)
{
    const std::int64_t reach = std::int64_t(frame.maskRadius) + frame.pitch;
    return {
        {floorDivide(sample.x - reach, frame.pitch), floorDivide(sample.y - reach, frame.pitch)},
        {floorDivide(sample.x + reach, frame.pitch), floorDivide(sample.y + reach, frame.pitch)}};
}

} // namespace core
