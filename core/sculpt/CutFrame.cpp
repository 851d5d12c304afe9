// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/CutFrame.h"

#include <algorithm>
#include <cstdlib>

namespace core {

CutColumn restoringColumn(
    const CutFrame& frame, const SurfaceHit& hit, std::int32_t from, std::int32_t weight)
{
    const std::int32_t r = frame.rampHalfWidth;
    const std::int32_t lastVoxel = (frame.front >> 1) + r;
    from = std::min(from, hit.zSurface - lastVoxel);
    const bool all = from - hit.zExit <= frame.front - (r >> 3);
    if (all)
        from = hit.zExit - 2 * frame.front - 2 * r;
    return {from, hit.zSurface + lastVoxel, weight};
}

glm::ivec3 planeBase(const CutFrame& frame, const glm::ivec3& firstVoxel)
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

std::optional<std::int32_t> searchEnd(const CutFrame& frame, const glm::ivec3& volumeSize,
    const glm::ivec2& element, const SurfaceHit& hit)
{
    using fixedPoint::round14;
    if (hit.zSurface != SurfaceHit::none && !frame.restore)
        return hit.zSurface;
    std::int64_t first = 0;
    std::int64_t last = std::int64_t(frame.sampleCount) - 1;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = std::size_t(axis);
        std::int64_t from = round14(
            frame.rayOrigin[i] + element.x * frame.rayPerA[i] + element.y * frame.rayPerB[i]);
        std::int64_t step = round14(frame.rayPerSample[i]);
        // Rule 3: lowest <= from + n * step <= highest; from here on told from the side it goes to.
        const std::int64_t lowest = -(std::int64_t(1) << 15);
        const std::int64_t highest = (std::int64_t(2 * volumeSize[axis] - 1) << 15) - 1;
        const std::int64_t end = highest - lowest;
        from = step < 0 ? highest - from : from - lowest;
        step = std::abs(step);
        // 0 <= from + n * step <= end
        if (step == 0 && (from < 0 || from > end))
            last = -1;
        else if (step > 0 && from > end)
            last = -1;
        else if (step > 0) {
            first = std::max(first, from >= 0 ? 0 : (-from + step - 1) / step);
            last = std::min(last, (end - from) / step);
        }
    }
    if (first > last)
        return std::nullopt;
    return std::int32_t(frame.zStart + last * frame.zPerSample);
}

Result<void> checkSound(const CutFrame& frame)
{
    if (frame.pitch < 1 || frame.rampHalfWidth < 1 || frame.gapSamples < 1)
        return failure(ErrorCode::InvalidField, QStringLiteral("frame"),
            Clause::saying("pitch, rampHalfWidth and gapSamples are at least 1"));
    if (!isSound(frame.hidden))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("hidden"), Clause::saying("is not sound"));
    return {};
}

} // namespace core
