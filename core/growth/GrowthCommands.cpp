// SPDX-License-Identifier: Apache-2.0
#include "core/growth/GrowthCommands.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

// So that areas of fronts times factors fit 64 bits: voxels of 31 mm.
constexpr std::int64_t greatestAreaUm2 = 1'000'000'000;
constexpr std::int64_t greatestVolumeUm3 = 1'000'000'000'000'000;

std::int64_t rootOf(std::int64_t square)
{
    std::int64_t root = 0;
    for (std::int64_t bit = std::int64_t(1) << 31; bit > 0; bit >>= 1) {
        if ((root + bit) * (root + bit) <= square)
            root += bit;
    }
    return root;
}

Result<void> checkConnectivity(int connectivity)
{
    if (connectivity != 6 && connectivity != 18 && connectivity != 26)
        return failure(ErrorCode::InvalidField, QStringLiteral("connectivity"),
            Clause::saying("is not 6, 18 or 26"));
    return {};
}

} // namespace

FrontMeasure frontMeasure(const glm::dvec3& spacingMm)
{
    std::array<std::int64_t, 3> um{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        um[axis] =
            std::int64_t(std::clamp(std::floor(spacingMm[int(axis)] * 1000.0 + 0.5), 1.0, 1.0e6));
    std::array<std::int64_t, 3> face{}; // across each axis
    for (std::size_t axis = 0; axis < 3; ++axis)
        face[axis] = std::min(um[(axis + 1) % 3] * um[(axis + 2) % 3], greatestAreaUm2);
    FrontMeasure measure{.volumeUm3 = std::min(face[0] * um[0], greatestVolumeUm3)};
    measure.areaUm2[0] = *std::min_element(face.begin(), face.end());
    for (std::size_t axes = 1; axes < measure.areaUm2.size(); ++axes) {
        std::int64_t square = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            square += (axes >> axis & 1u) != 0 ? face[axis] * face[axis] : 0;
        measure.areaUm2[axes] = std::min(rootOf(square), greatestAreaUm2);
    }
    return measure;
}

bool isSound(const GuardRule& rule)
{
    constexpr int greatestFactor256 = 256000;
    constexpr std::int64_t greatestExcess = 1'000'000'000'000;
    constexpr std::int64_t greatestWindow = 1'000'000'000;
    const auto between = [](std::int64_t value, std::int64_t low, std::int64_t high) {
        return value >= low && value <= high;
    };
    const bool measured = !rule.measure
        || (between(rule.measure->volumeUm3, 1, greatestVolumeUm3)
            && std::all_of(rule.measure->areaUm2.begin(), rule.measure->areaUm2.end(),
                [&](std::int64_t area) { return between(area, 1, greatestAreaUm2); }));
    return measured && between(rule.factor256, 1, greatestFactor256)
        && between(rule.excess, 0, greatestExcess) && between(rule.window, 1, greatestWindow);
}

bool isSound(const GrowLimits& limits)
{
    const auto between = [](int value, int low, int high) { return value >= low && value <= high; };
    for (int axis = 0; axis < 3; ++axis) {
        if (!between(limits.gradientWeights[axis], 0, 65535))
            return false;
    }
    return limits.difference.value_or(0) >= 0 && limits.gradient.value_or(0) >= 0
        && limits.gradientDifference.value_or(0) >= 0 && between(limits.majority, 0, 27)
        && between(limits.sigmas256, 0, 25600) && isSound(limits.passage);
}

bool isSound(const GrowBurst& burst)
{
    const bool rolls = isAsked(burst.limits.passage);
    return isSound(burst.limits) && isSound(burst.seedGroups)
        && (!burst.guard || isSound(*burst.guard))
        && (!rolls || (burst.opening != GrowOpening::Narrow && burst.tellsHeld));
}

bool isSound(const BarrierListed& edit, int brickCount)
{
    std::int64_t last = -1;
    for (const BarrierListed::Brick& brick : edit.bricks) {
        if (std::int64_t(brick.brick) <= last || std::int64_t(brick.brick) >= brickCount)
            return false;
        last = brick.brick;
    }
    return true;
}

Result<void> checkSound(const SeedPlacement& edit, const BrickGrid& grid)
{
    if (edit.label == 0)
        return failure(
            ErrorCode::InvalidField, QStringLiteral("label"), Clause::saying("0 is no segment"));
    const Result<void> taken = checkWithin(edit.taken, grid);
    return taken ? checkWithin(edit.voxels, grid) : taken;
}

Result<void> checkSound(const GrowBurst& edit, const BrickGrid& grid)
{
    if (const Result<void> checked = checkConnectivity(edit.connectivity); !checked)
        return checked;
    if (!isSound(edit))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("limits"), Clause::saying("are not sound"));
    return checkSound(edit.seedGroups, grid);
}

Result<void> checkSound(const ShrinkGrowth& edit, const BrickGrid&)
{
    if (edit.keep > edit.generation)
        return failure(ErrorCode::InvalidField, QStringLiteral("keep"),
            Clause::saying("is more than there is"));
    return {};
}

Result<void> checkSound(const CutGrowth& edit, const BrickGrid& grid)
{
    if (const Result<void> checked = checkConnectivity(edit.connectivity); !checked)
        return checked;
    if (edit.steps < 1)
        return failure(
            ErrorCode::InvalidField, QStringLiteral("steps"), Clause::saying("are none"));
    return checkWithin(edit.voxels, grid);
}

Result<void> checkSound(const PaintBarrier& edit, const BrickGrid&)
{
    if (!isSound(edit.frame))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("frame"), Clause::saying("is not sound"));
    return {};
}

Result<void> checkSound(const BarrierListed& edit, const BrickGrid& grid)
{
    if (!isSound(edit, grid.brickCount()))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("bricks"), Clause::saying("are not sound"));
    return {};
}

} // namespace core
