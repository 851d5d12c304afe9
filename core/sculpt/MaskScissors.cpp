// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/MaskScissors.h"

#include "core/sculpt/DrillCut.h"

namespace core {

MaskColumn scissorsColumn(const MaskScissors& scissors, const SurfaceHit& hit, std::int32_t weight)
{
    const MaskFrame& frame = scissors.frame;
    const std::int32_t part = (weight * 255 + 128) >> 8;
    if (!scissors.fromSurface) {
        const std::int32_t r = frame.rampHalfWidth;
        return {frame.zStart - 2 * r, frame.zStart + frame.sampleCount * frame.zPerSample + 2 * r,
            part};
    }
    MaskColumn column = drillColumn(frame, hit, frame.maxDepth);
    if (column.weight > 0)
        column.weight = part;
    return column;
}

Result<void> checkSound(const MaskScissors& scissors, const BrickGrid&)
{
    return checkSound(scissors.frame);
}

} // namespace core
