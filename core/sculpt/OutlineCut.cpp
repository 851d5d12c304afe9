// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/OutlineCut.h"

#include "core/sculpt/DrillCut.h"

namespace core {

CutColumn scissorsColumn(const OutlineCut& scissors, const SurfaceHit& hit, std::int32_t weight)
{
    const CutFrame& frame = scissors.frame;
    const std::int32_t part = (weight * 255 + 128) >> 8;
    if (!scissors.fromSurface) {
        const std::int32_t r = frame.rampHalfWidth;
        return {frame.zStart - 2 * r, frame.zStart + frame.sampleCount * frame.zPerSample + 2 * r,
            part};
    }
    CutColumn column = drillColumn(frame, hit, frame.maxDepth);
    if (column.weight > 0)
        column.weight = part;
    return column;
}

Result<void> checkSound(const OutlineCut& scissors, const BrickGrid&)
{
    return checkSound(scissors.frame);
}

} // namespace core
