// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/growth/GrowthAnswers.h"

#include <algorithm>
#include <array>
#include <utility>

namespace test {

namespace {

using core::GrowAdvance;
using core::GrowBurst;
using core::GrowLimits;
using core::GrowOpening;
using core::SeedPlacement;

constexpr int closure = GrowAdvance::toClosure;

/// Codes that rise evenly along the axes, with some noise on top.
Codes slopes(const glm::ivec3& size, const glm::ivec3& rise, int noise, Random& random)
{
    Codes codes{size, {}};
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                codes.values.push_back(std::uint16_t(std::clamp(
                    100 + rise.x * x + rise.y * y + rise.z * z + randomInt(random, 0, noise), 0,
                    65535)));
    return codes;
}

/// Codes of 0 and 65535 only.
Codes extremes(const glm::ivec3& size, Random& random)
{
    Codes codes = noiseVolume(size, 3, random);
    for (std::uint16_t& code : codes.values)
        code = code == 0 ? 0 : 65535;
    return codes;
}

Codes randomCodes(const glm::ivec3& size, Random& random)
{
    switch (random() % 5) {
    case 0:
        return noiseVolume(size, tissueCode, random);
    case 1:
        return extremes(size, random);
    case 2:
        return balls(size, randomInt(random, 2, 8), random);
    default:
        return slopes(size,
            {randomInt(random, 0, 30), randomInt(random, 0, 30), randomInt(random, 0, 30)},
            randomInt(random, 0, 20), random);
    }
}

glm::ivec3 randomSize(Random& random)
{
    if (random() % 4 == 0)
        return {randomInt(random, 1, 3), randomInt(random, 1, 40), randomInt(random, 1, 5)};
    return {randomInt(random, 5, 36), randomInt(random, 5, 36), randomInt(random, 5, 36)};
}

GrowLimits randomLimits(const glm::ivec3& size, Random& random)
{
    GrowLimits limits;
    const int scale = random() % 4 == 0 ? 65535 : 60;
    if (random() % 3 == 0)
        limits.difference = randomInt(random, 0, scale);
    if (random() % 3 == 0)
        limits.gradient = randomInt(random, 0, scale);
    if (random() % 3 == 0)
        limits.gradientDifference = randomInt(random, 0, scale);
    for (int axis = 0; axis < 3; ++axis)
        limits.gradientWeights[axis] = randomInt(random, 0, random() % 4 == 0 ? 65535 : 1024);
    if (random() % 3 == 0)
        limits.majority = randomInt(random, 0, 27);
    limits.onlyVisible = random() % 3 == 0;
    limits.boxed = random() % 3 == 0;
    limits.boxFrom = randomVoxel(random, size) - randomInt(random, 0, 12);
    limits.boxTo = randomVoxel(random, size) + randomInt(random, 0, 12);
    if (random() % 2)
        limits.sigmas256 = randomInt(random, 0, 25600 / (random() % 4 == 0 ? 1 : 20));
    return limits;
}

core::SwapBricks randomCoverage(const glm::ivec3& size, std::uint8_t layer, Random& random)
{
    Bytes bytes{size, {}};
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                bytes.values.push_back(std::uint8_t(
                    (x / 4 + y / 4 + z / 4 + layer) % 3 ? 0 : randomInt(random, 90, 255)));
    return {bricksOf(bytes, core::Field::Coverage, layer)};
}

EngineCase randomCase(int number)
{
    Random random(std::uint32_t(61000 + number));
    Random openings(std::uint32_t(63000 + number));
    Random smoothings(std::uint32_t(65000 + number));
    const glm::ivec3 size = randomSize(random);
    EngineCase made{"random limits " + QByteArray::number(number), randomCodes(size, random), {}};
    for (const int layer : {1, 2}) {
        if (random() % 2)
            made.steps.push_back(command(randomCoverage(size, std::uint8_t(layer), random)));
    }
    for (int burst = randomInt(random, 1, 4); burst > 0; --burst) {
        if (random() % 3 == 0) {
            core::MuteLayers mute;
            mute.muted.set(std::size_t(randomInt(random, 1, 2)));
            made.steps.push_back(command(mute));
        }
        for (int stroke = randomInt(random, 1, 3); stroke > 0; --stroke) {
            SeedPlacement seeds{.label = std::uint8_t(randomInt(random, 1, 4))};
            appendSeeds(made.steps, seeds, randomInt(random, 1, 6), size, random);
        }
        const std::uint16_t seen = made.codes.at(randomVoxel(random, size));
        GrowBurst grow{.lowCode = std::max(int(seen) - randomInt(random, 0, 700), 0),
            .highCode = int(seen) + randomInt(random, 0, 700),
            .connectivity = std::array<int, 3>{6, 18, 26}[random() % 3],
            .limits = randomLimits(size, random)};
        if (random() % 3 == 0) {
            grow.lowCode = 0;
            grow.highCode = 65535;
        }
        grow.limits.smoothed = smoothings() % 3 == 0;
        if (random() % 4 == 0)
            grow.lockedLabels.set(std::size_t(randomInt(random, 1, 4)));
        grow.opening = std::array<GrowOpening, 4>{GrowOpening::GoOn, GrowOpening::Narrow,
            GrowOpening::Narrow, GrowOpening::Restart}[openings() % 4];
        made.steps.push_back(command(core::ProbeSeeds{0, grow.lowCode, grow.highCode}));
        made.steps.push_back(BeginGrowth{grow});
        if (random() % 2)
            made.steps.push_back(command(core::ExtendEdit{GrowAdvance{randomInt(random, 0, 5)}}));
        if (random() % 3)
            made.steps.push_back(command(core::ExtendEdit{GrowAdvance{closure}}));
        made.steps.push_back(command(core::EndEdit{}));
        if (random() % 3 == 0)
            made.steps.push_back(
                Shrink{.shrink = {}, .generations = std::uint32_t(randomInt(random, 0, 4))});
        if (random() % 4 == 0)
            made.steps.push_back(Undo{});
    }
    return made;
}

EngineCase grown(const QByteArray& name, Codes codes, const std::vector<glm::ivec3>& seeds,
    const GrowBurst& burst)
{
    EngineCase made{name, std::move(codes), {}};
    appendWhole(made.steps, SeedPlacement{.label = 200, .voxels = seeds});
    made.steps.push_back(command(core::ProbeSeeds{0, burst.lowCode, burst.highCode}));
    made.steps.push_back(BeginGrowth{burst});
    made.steps.push_back(command(core::ExtendEdit{GrowAdvance{closure}}));
    made.steps.push_back(command(core::EndEdit{}));
    made.steps.push_back(Undo{});
    made.steps.push_back(Redo{});
    return made;
}

/// Growths that compare medians with their interval. Other families of cases are drawn by counting
/// (RefusedMemoryGlTest): seven here leave them as they were.
std::vector<EngineCase> smoothedCases(const glm::ivec3& size)
{
    Random random(4343);
    const auto smoothed = [](int low, int high, int connectivity = 6) {
        return GrowBurst{.lowCode = low,
            .highCode = high,
            .connectivity = connectivity,
            .limits = {.smoothed = true}};
    };
    // At borders and corners of the volume and of bricks, too.
    const std::vector<glm::ivec3> places{
        {5, 5, 5}, {0, 0, 0}, {32, 17, 19}, {16, 9, 0}, {15, 16, 16}};
    std::vector<EngineCase> cases;
    for (const int connectivity : {6, 26})
        cases.push_back(
            grown("medians of noise, " + QByteArray::number(connectivity) + " neighbours",
                noiseVolume(size, 999, random), places, smoothed(350, 620, connectivity)));
    cases.push_back(grown("medians on flat axes", noiseVolume({1, 1, 30}, 90, random), {{0, 0, 3}},
        smoothed(20, 70)));
    GrowBurst bySeeds = smoothed(0, 65535);
    bySeeds.limits.sigmas256 = 300;
    cases.push_back(
        grown("medians of extremes, by seeds", extremes(size, random), places, bySeeds));
    GrowBurst byMost = smoothed(300, 999, 26);
    byMost.limits.majority = 19;
    cases.push_back(
        grown("medians and a majority", noiseVolume(size, 999, random), places, byMost));

    EngineCase ends{"medians at the ends of the range", extremes(size, random), {}};
    appendWhole(ends.steps, SeedPlacement{.label = 200, .voxels = places});
    for (const auto& [low, high] : {std::pair{0, 0}, std::pair{65535, 65535}, std::pair{1, 65534},
             std::pair{0, 65535}, std::pair{9, 8}}) {
        ends.steps.push_back(BeginGrowth{smoothed(low, high)});
        ends.steps.push_back(command(core::ExtendEdit{GrowAdvance{closure}}));
        ends.steps.push_back(command(core::EndEdit{}));
        ends.steps.push_back(Undo{});
    }
    cases.push_back(ends);

    EngineCase moved{"an interval moves over medians", noiseVolume(size, 999, random), {}};
    appendWhole(moved.steps, SeedPlacement{.label = 200, .voxels = places});
    for (const auto& [low, high] : {std::pair{350, 620}, std::pair{420, 560}, std::pair{400, 700},
             std::pair{0, 65535}, std::pair{450, 500}}) {
        GrowBurst burst = smoothed(low, high, 26);
        burst.opening = GrowOpening::Narrow;
        moved.steps.push_back(BeginGrowth{burst});
        moved.steps.push_back(command(core::ExtendEdit{GrowAdvance{low == 400 ? 2 : closure}}));
        moved.steps.push_back(command(core::EndEdit{}));
    }
    moved.steps.push_back(Undo{});
    moved.steps.push_back(Undo{});
    cases.push_back(moved);
    return cases;
}

} // namespace

std::vector<EngineCase> growLimitCases(int randomCount)
{
    Random random(4242);
    const glm::ivec3 size(33, 18, 20);
    const auto whole = [](const GrowLimits& limits, int connectivity = 6) {
        return GrowBurst{
            .lowCode = 0, .highCode = 65535, .connectivity = connectivity, .limits = limits};
    };
    std::vector<EngineCase> cases;
    for (const int difference : {0, 9, 10, 19, 20, 65535})
        cases.push_back(grown("slope, difference " + QByteArray::number(difference),
            slopes(size, {10, 20, 3}, 0, random), {{5, 5, 5}}, whole({.difference = difference})));
    // 10, 20 and 3 codes a voxel, of half weight at the rim: √(10² + 20² + 3²) = 22.56 inside.
    for (const int gradient : {0, 11, 22, 23, 65534, 65535, 1 << 30})
        cases.push_back(grown("slope, gradient " + QByteArray::number(gradient),
            slopes(size, {10, 20, 3}, 0, random), {{5, 5, 5}, {0, 0, 0}},
            whole({.gradient = gradient, .gradientWeights = glm::ivec3(512)}, 18)));
    for (const int difference : {0, 5, 9, 40000})
        cases.push_back(grown("gradient difference " + QByteArray::number(difference),
            slopes(size, {10, 20, 3}, 6, random), {{5, 5, 5}},
            whole({.gradientDifference = difference, .gradientWeights = {512, 700, 100}}, 26)));
    const GrowLimits steepest{.gradient = 56754, // ⌊√3 · 32767⌋ is one more
        .gradientDifference = 30000,
        .gradientWeights = glm::ivec3(65535)};
    cases.push_back(
        grown("the steepest there is", extremes(size, random), {{5, 5, 5}}, whole(steepest, 26)));
    cases.push_back(grown("flat axes", noiseVolume({1, 1, 30}, 90, random), {{0, 0, 3}},
        whole({.gradient = 20, .gradientWeights = glm::ivec3(512)})));
    for (const int majority : {1, 13, 14, 26, 27}) {
        GrowBurst burst = whole({.majority = majority}, 26);
        burst.lowCode = 300;
        cases.push_back(
            grown("majority " + QByteArray::number(majority), noiseVolume(size, 999, random),
                {{5, 5, 5}, {0, 0, 0}, {32, 17, 19}, {16, 9, 0}}, burst));
    }
    cases.push_back(grown("box of one voxel", constantVolume(size, 5), {{5, 5, 5}, {6, 5, 5}},
        whole({.boxed = true, .boxFrom = {5, 5, 5}, .boxTo = {5, 5, 5}})));
    cases.push_back(grown("box upside down", constantVolume(size, 5), {{5, 5, 5}},
        whole({.boxed = true, .boxFrom = {6, 0, 0}, .boxTo = {5, 17, 19}})));
    cases.push_back(grown("box beyond the volume", constantVolume(size, 5), {{5, 5, 5}},
        whole({.boxed = true, .boxFrom = {-9, 4, -1000000}, .boxTo = {1000000, 40, 20}})));
    std::vector<glm::ivec3> many;
    for (int i = 0; i < 400; ++i)
        many.push_back(randomVoxel(random, size));
    for (const int sigmas256 : {1, 256, 25600}) {
        const QByteArray name = ", " + QByteArray::number(sigmas256) + " / 256 sigmas";
        cases.push_back(grown("seeds all alike" + name, constantVolume(size, 65535), many,
            whole({.sigmas256 = sigmas256}))); // sums beyond 32 bits
        cases.push_back(grown("seeds at the ends of the range" + name, extremes(size, random), many,
            whole({.sigmas256 = sigmas256})));
        cases.push_back(grown("seeds on a slope" + name, slopes(size, {10, 20, 3}, 9, random),
            {{5, 5, 5}, {0, 0, 0}}, whole({.sigmas256 = sigmas256}, 18)));
        GrowBurst none = whole({.sigmas256 = sigmas256});
        none.lowCode = 7;
        cases.push_back(
            grown("nothing around the seeds" + name, constantVolume(size, 5), {{5, 5, 5}}, none));
    }

    EngineCase labels{"each label by its own seeds", slopes(size, {40, 0, 0}, 9, random), {}};
    appendWhole(labels.steps, SeedPlacement{.label = 3, .voxels = {{4, 5, 5}, {5, 9, 9}}});
    appendWhole(labels.steps, SeedPlacement{.label = 255, .voxels = {{28, 5, 5}}});
    labels.steps.push_back(BeginGrowth{whole({.majority = 14, .sigmas256 = 500})});
    labels.steps.push_back(command(core::ExtendEdit{GrowAdvance{3}}));
    labels.steps.push_back(command(core::EndEdit{}));
    // Accepted seeds count again, new ones too, wider now.
    appendWhole(labels.steps, SeedPlacement{.label = 3, .voxels = {{20, 5, 5}}});
    labels.steps.push_back(BeginGrowth{whole({.majority = 14, .sigmas256 = 600})});
    labels.steps.push_back(command(core::ExtendEdit{GrowAdvance{closure}}));
    labels.steps.push_back(command(core::EndEdit{}));
    cases.push_back(labels);

    for (const bool muted : {false, true}) {
        EngineCase visible{
            muted ? "carved, but muted" : "carved is closed", constantVolume(size, 5), {}};
        visible.steps.push_back(command(randomCoverage(size, 1, random)));
        visible.steps.push_back(command(randomCoverage(size, 2, random)));
        if (muted)
            visible.steps.push_back(command(core::MuteLayers{std::bitset<256>().set(2)}));
        appendWhole(visible.steps, SeedPlacement{.label = 1, .voxels = many});
        visible.steps.push_back(BeginGrowth{whole({.onlyVisible = true})});
        visible.steps.push_back(command(core::ExtendEdit{GrowAdvance{closure}}));
        visible.steps.push_back(command(core::EndEdit{}));
        cases.push_back(visible);
    }

    for (EngineCase& each : smoothedCases(size))
        cases.push_back(std::move(each));

    EngineCase refused{"limits that are not sound", constantVolume({4, 4, 4}, 5), {}};
    for (const GrowLimits& limits : {GrowLimits{.difference = -1}, GrowLimits{.gradient = -1},
             GrowLimits{.gradientDifference = -1}, GrowLimits{.gradientWeights = {0, 65536, 0}},
             GrowLimits{.gradientWeights = {0, 0, -1}}, GrowLimits{.majority = 28},
             GrowLimits{.majority = -1}, GrowLimits{.sigmas256 = -1},
             GrowLimits{.sigmas256 = 25601}})
        refused.steps.push_back(command(core::BeginEdit{whole(limits)}));
    cases.push_back(refused);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(daily(randomCase(number), std::size_t(number)));
    return cases;
}

} // namespace test
