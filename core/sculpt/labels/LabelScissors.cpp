// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/labels/LabelScissors.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace core {

namespace {

/// Whether the places of a mask, in mm16, can be reckoned with in 32 bits.
bool liesInReach(const OutlineRaster& mask, std::int32_t pitch)
{
    constexpr std::int64_t farthest = std::int64_t(1) << 30;
    for (int axis = 0; axis < 2; ++axis) {
        const std::int64_t first = mask.first[axis];
        if (std::abs(first) * pitch > farthest
            || std::abs(first + mask.size[axis]) * pitch > farthest)
            return false;
    }
    return true;
}

/// Where the voxels of a brick lie along an axis of the plane, mm16, both ends included.
struct PlaneSpan {
    std::int64_t low = 0;
    std::int64_t high = 0;
};

PlaneSpan spanOf(const CutFrame& frame, const glm::ivec3& base, int axis)
{
    PlaneSpan span{base[axis], base[axis]};
    for (const Fixed3* const step : {&frame.planePerI, &frame.planePerJ, &frame.planePerK}) {
        const std::int64_t across =
            (BrickGrid::side - 1) * fixedPoint::round14((*step)[std::size_t(axis)]);
        (across < 0 ? span.low : span.high) += across;
    }
    return span;
}

} // namespace

Result<void> checkSound(const LabelScissors& edit, const BrickGrid&)
{
    const auto unsound = [](const char* field, const Clause& reason) {
        return failure(ErrorCode::InvalidField, QLatin1String(field), reason);
    };
    if (!edit.erases() && edit.target.label == 0)
        return unsound("label", Clause::saying("0 is no segment"));
    if (edit.erased[0])
        return unsound("erased", Clause::saying("0 is no segment"));
    if (edit.outside && edit.fromSurface)
        return unsound("outside", Clause::saying("has no surface"));
    if (const Result<void> sound = checkSound(edit.frame); !sound)
        return sound;
    const glm::ivec2& size = edit.mask.size;
    if (size.x < 0 || size.y < 0
        || edit.mask.values.size() != std::size_t(size.x) * std::size_t(size.y)
        || !liesInReach(edit.mask, edit.frame.pitch))
        return unsound("mask", Clause::saying("is not sound"));
    return checkSound(edit.editable);
}

std::vector<std::uint32_t> bricksNear(const LabelScissors& edit, const BrickGrid& grid)
{
    std::vector<std::uint32_t> near(std::size_t(grid.brickCount()));
    std::iota(near.begin(), near.end(), 0u);
    if (edit.outside)
        return near;
    std::erase_if(near, [&](std::uint32_t brick) {
        const glm::ivec3 base = planeBase(edit.frame, grid.boxOf(int(brick)).minimum);
        for (int axis = 0; axis < 2; ++axis) {
            const PlaneSpan span = spanOf(edit.frame, base, axis);
            const std::int64_t first = std::int64_t(edit.mask.first[axis]) * edit.frame.pitch;
            const std::int64_t end = first + std::int64_t(edit.mask.size[axis]) * edit.frame.pitch;
            if (span.high < first || span.low >= end)
                return true;
        }
        return false;
    });
    return near;
}

std::vector<std::int32_t> scissorsReach(
    const LabelScissors& edit, std::span<const std::int32_t> surfaces)
{
    constexpr std::int64_t farthest = std::numeric_limits<std::int32_t>::max();
    std::vector<std::int32_t> reach(edit.mask.values.size(), LabelScissors::nowhere);
    for (std::size_t i = 0; i < reach.size(); ++i) {
        if (edit.mask.values[i] < LabelScissors::covered)
            continue;
        if (!edit.fromSurface)
            reach[i] = std::int32_t(farthest);
        else if (surfaces[i] != SurfaceHit::none)
            reach[i] =
                std::int32_t(std::min(std::int64_t(surfaces[i]) + edit.frame.maxDepth, farthest));
    }
    return reach;
}

} // namespace core
