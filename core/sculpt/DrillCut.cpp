// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/DrillCut.h"

#include <algorithm>

namespace core {

using fixedPoint::floorDivide;

namespace {

glm::ivec2 elementOf(const DrillCut& cut, const DrillSample& sample)
{
    return {floorDivide(sample.x, cut.frame.pitch), floorDivide(sample.y, cut.frame.pitch)};
}

} // namespace

std::int32_t maskWeight(const DrillCut& cut, const DrillSample& sample, const glm::ivec2& element)
{
    if (!cut.mask.empty())
        return cut.mask.at(element - elementOf(cut, sample));
    const std::int64_t pitch = cut.frame.pitch;
    const std::int64_t dx = element.x * pitch + pitch / 2 - sample.x;
    const std::int64_t dy = element.y * pitch + pitch / 2 - sample.y;
    const std::int64_t distance = fixedPoint::squareRoot(dx * dx + dy * dy);
    const std::int64_t scaled = (cut.maskRadius - distance) * 256 + 128 * pitch;
    return scaled <= 0 ? 0 : std::int32_t(std::min<std::int64_t>(scaled / pitch, 256));
}

std::int64_t contribution(const DrillCut& cut, const DrillSample& sample, std::int32_t weight)
{
    const std::int64_t product = std::int64_t(sample.depth) * weight;
    return cut.mode == DrillMode::Limit ? product >> 8 : product;
}

CutColumn drillColumn(const CutFrame& frame, const SurfaceHit& hit, std::int32_t depth)
{
    if (hit.zSurface == SurfaceHit::none || depth <= 0)
        return {};
    if (frame.restore)
        return restoringColumn(frame, hit, hit.zSurface - depth, 255);
    return {hit.zSurface - frame.front, std::min(hit.zSurface + depth, hit.zExit), 255};
}

ElementBox elementsUnder(const DrillCut& cut, const DrillSample& sample)
{
    if (!cut.mask.empty()) {
        const glm::ivec2 first = elementOf(cut, sample) + cut.mask.first;
        return {first, first + cut.mask.size - 1};
    }
    const std::int64_t reach = std::int64_t(cut.maskRadius) + cut.frame.pitch;
    return {{floorDivide(sample.x - reach, cut.frame.pitch),
                floorDivide(sample.y - reach, cut.frame.pitch)},
        {floorDivide(sample.x + reach, cut.frame.pitch),
            floorDivide(sample.y + reach, cut.frame.pitch)}};
}

Result<void> checkSound(const DrillCut& cut, const BrickGrid&)
{
    return checkSound(cut.frame);
}

} // namespace core
