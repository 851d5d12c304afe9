// SPDX-License-Identifier: Apache-2.0
// Statistics of seeds by groups (core::GrowLimits), as those of strokes.
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/cases/growth/GrowthAnswers.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace test {

namespace {

using core::GrowAdvance;
using core::GrowBurst;
using core::GrowOpening;
using core::SeedGroup;
using core::SeedPlacement;

using Voxels = std::vector<glm::ivec3>;

constexpr int groupClosure = GrowAdvance::toClosure;

Voxels ordered(Voxels voxels)
{
    std::sort(voxels.begin(), voxels.end(), [](const glm::ivec3& a, const glm::ivec3& b) {
        return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
    });
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
    return voxels;
}

SeedGroup groupOf(std::uint8_t label, Voxels voxels)
{
    return {.label = label, .voxels = ordered(std::move(voxels))};
}

/// Tissues side by side along x, each so wide, with noise: means that lie 100 codes apart.
Codes tissues(const glm::ivec3& size, int width, int noise, Random& random)
{
    Codes codes{size, {}};
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                codes.values.push_back(
                    std::uint16_t(300 + 100 * (x / width) + randomInt(random, -noise, noise)));
    return codes;
}

GrowBurst narrowed(int sigmas256, std::vector<SeedGroup> groups, int connectivity = 6)
{
    return {.lowCode = 0,
        .highCode = 65535,
        .connectivity = connectivity,
        .limits = {.sigmas256 = sigmas256},
        .seedGroups = std::move(groups)};
}

void appendSeeds(EngineCase& made, std::uint8_t label, Voxels voxels, Voxels taken = {})
{
    appendWhole(made.steps,
        SeedPlacement{.label = label, .voxels = std::move(voxels), .taken = std::move(taken)});
}

void appendGrowth(EngineCase& made, const GrowBurst& burst, int steps = groupClosure)
{
    made.steps.push_back(
        command(core::ProbeSeeds{burst.plane, burst.lowCode, burst.highCode, burst.seedGroups}));
    made.steps.push_back(BeginGrowth{burst});
    made.steps.push_back(command(core::ExtendEdit{GrowAdvance{steps}}));
    made.steps.push_back(command(core::EndEdit{}));
}

core::Document documentOf(const glm::ivec3& size, Random& random)
{
    core::Document document = randomDocument(size, random, false);
    for (int label = 1; label <= 4; ++label)
        document.segments.push_back({.label = std::uint8_t(label), .plane = 0});
    return document;
}

/// Seeds that are painted: members that no list of strokes holds.
void appendPainted(
    EngineCase& made, const core::Document& document, int label, bool erase, Random& random)
{
    core::PaintStroke stroke = randomPaint(document, random);
    stroke.segment = label;
    stroke.seeds = true;
    stroke.erase = erase;
    stroke.lower.reset();
    stroke.upper.reset();
    stroke.edgeTolerance.reset();
    stroke.toleranceByPressure.reset();
    if (const auto paint = core::paintLabel(stroke, document))
        appendWhole(made.steps, *paint,
            {core::CapsulePath{core::capsules(stroke.path, document.volumes.front().geometry)}});
}

EngineCase randomGroupCase(int number)
{
    Random random(std::uint32_t(91000 + number));
    const glm::ivec3 size{
        randomInt(random, 4, 48), randomInt(random, 4, 30), randomInt(random, 3, 24)};
    EngineCase made{"random groups of seeds " + QByteArray::number(number),
        random() % 4 ? tissues(size, randomInt(random, 3, 14), randomInt(random, 0, 60), random)
                     : noiseVolume(size, random() % 2 ? 65535 : 900, random),
        {}};
    const core::Document document = documentOf(size, random);
    std::vector<SeedGroup> strokes;
    for (int burst = randomInt(random, 1, 4); burst > 0; --burst) {
        for (int stroke = randomInt(random, 1, 5); stroke > 0; --stroke) {
            SeedGroup seeds{.label = std::uint8_t(randomInt(random, 1, 3))};
            for (int i = randomInt(random, 1, 8); i > 0; --i)
                seeds.voxels.push_back(randomVoxel(random, size));
            Voxels taken;
            if (!strokes.empty() && random() % 4 == 0)
                taken = strokes[random() % strokes.size()].voxels;
            appendSeeds(made, seeds.label, seeds.voxels, taken);
            if (random() % 6)
                strokes.push_back(groupOf(seeds.label, seeds.voxels));
        }
        if (random() % 4 == 0)
            appendPainted(made, document, randomInt(random, 1, 3), random() % 3 == 0, random);
        if (!strokes.empty() && random() % 5 == 0) {
            // Of a label that has no such seeds, and of places where none is.
            SeedGroup other = strokes[random() % strokes.size()];
            other.label = std::uint8_t(randomInt(random, 1, 255));
            other.voxels.push_back(randomVoxel(random, size));
            strokes.push_back(groupOf(other.label, other.voxels));
        }
        GrowBurst grow = narrowed(randomInt(random, random() % 8 ? 1 : 0, 1500), strokes,
            std::array<int, 3>{6, 18, 26}[random() % 3]);
        if (random() % 2) {
            grow.lowCode = randomInt(random, 0, 400);
            grow.highCode = grow.lowCode + randomInt(random, 0, 900);
        }
        if (random() % 3 == 0)
            grow.limits.majority = randomInt(random, 0, 20);
        if (random() % 6 == 0)
            grow.limits.passage = {.spacing = glm::ivec3(64), .reach = 64 * 64};
        if (random() % 4 == 0)
            grow.lockedLabels.set(std::size_t(randomInt(random, 1, 3)));
        grow.opening = core::isAsked(grow.limits.passage)
            ? GrowOpening::Restart
            : std::array<GrowOpening, 3>{
                GrowOpening::GoOn, GrowOpening::Narrow, GrowOpening::Restart}[random() % 3];
        appendGrowth(made, grow, random() % 3 ? groupClosure : randomInt(random, 0, 6));
        if (random() % 4 == 0)
            made.steps.push_back(
                Shrink{.shrink = {}, .generations = std::uint32_t(randomInt(random, 0, 5))});
        if (random() % 5 == 0)
            made.steps.push_back(Undo{});
    }
    return made;
}

} // namespace

std::vector<EngineCase> seedGroupCases(int randomCount)
{
    Random random(777);
    std::vector<EngineCase> cases;
    const glm::ivec3 size(50, 18, 19);
    const Codes rows = tissues(size, 10, 20, random);
    const auto begun = [&rows](const QByteArray& name) { return EngineCase{name, rows, {}}; };
    const Voxels dark{{4, 8, 8}, {5, 8, 8}, {5, 9, 8}};
    const Voxels bright{{24, 8, 8}, {25, 8, 8}};

    for (const int connectivity : {6, 26}) {
        for (const int majority : {0, 14}) {
            EngineCase made =
                begun("two strokes in two tissues, " + QByteArray::number(connectivity)
                    + " neighbours, majority " + QByteArray::number(majority));
            appendSeeds(made, 3, dark);
            appendSeeds(made, 3, bright);
            for (const bool byStroke : {false, true}) {
                GrowBurst burst = narrowed(600,
                    byStroke ? std::vector{groupOf(3, dark), groupOf(3, bright)}
                             : std::vector<SeedGroup>(),
                    connectivity);
                burst.limits.majority = majority;
                appendGrowth(made, burst);
                made.steps.push_back(Undo{});
            }
            made.steps.push_back(Redo{});
            cases.push_back(made);
        }
    }
    {
        EngineCase made = begun("seeds in two strokes and in none");
        appendSeeds(made, 3, dark);
        appendSeeds(made, 3, bright);
        appendSeeds(made, 3, {{44, 8, 8}});
        appendGrowth(made,
            narrowed(500, {groupOf(3, {dark[0], dark[1]}), groupOf(3, {dark[1], bright[0]})}));
        cases.push_back(made);
    }
    {
        EngineCase made = begun("strokes of which nothing is left");
        appendSeeds(made, 3, dark);
        appendSeeds(made, 3, bright);
        appendSeeds(made, 3, {{44, 8, 8}}, dark);
        appendSeeds(made, 4, {bright[0]}); // the earlier label keeps it, the later may lose it
        appendGrowth(
            made, narrowed(500, {groupOf(3, dark), groupOf(3, bright), groupOf(4, {bright[0]})}));
        cases.push_back(made);
    }
    {
        EngineCase made = begun("strokes of several segments at the same places");
        appendSeeds(made, 3, dark);
        appendSeeds(made, 255, bright);
        appendGrowth(made,
            narrowed(400,
                {groupOf(3, bright), groupOf(255, dark), groupOf(3, dark), groupOf(255, bright),
                    groupOf(1, dark)}));
        cases.push_back(made);
    }
    {
        EngineCase made = begun("forty strokes");
        std::vector<SeedGroup> strokes;
        for (int stroke = 0; stroke < 40; ++stroke) {
            Voxels voxels;
            for (int i = randomInt(random, 1, 30); i > 0; --i)
                voxels.push_back(randomVoxel(random, size));
            appendSeeds(made, 200, voxels);
            strokes.push_back(groupOf(200, voxels));
        }
        appendGrowth(made, narrowed(100, strokes, 18));
        cases.push_back(made);
    }
    {
        EngineCase made = begun("sums beyond 32 bits");
        made.codes = constantVolume(size, 65535);
        Voxels all;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < 20; ++x)
                    all.push_back({x, y, z});
        appendSeeds(made, 1, all);
        appendGrowth(made, narrowed(256, {groupOf(1, all)}));
        cases.push_back(made);
    }
    {
        EngineCase made = begun("accepted seeds count as those that wait");
        appendSeeds(made, 3, dark);
        appendGrowth(made, narrowed(500, {groupOf(3, dark)}), 3);
        appendSeeds(made, 3, bright);
        GrowBurst wider = narrowed(700, {groupOf(3, dark), groupOf(3, bright)});
        wider.opening = GrowOpening::Restart;
        appendGrowth(made, wider);
        made.steps.push_back(BeginGrowth{wider});
        wider.limits.sigmas256 = 300;
        wider.seedGroups.pop_back();
        made.steps.push_back(command(core::ExtendEdit{core::GrowAnew{wider}}));
        made.steps.push_back(command(core::ExtendEdit{GrowAdvance{groupClosure}}));
        made.steps.push_back(command(core::EndEdit{}));
        cases.push_back(made);
    }
    for (const bool told : {false, true}) {
        // Painted seeds stand in no list.
        EngineCase made{told ? "painted seeds beside a stroke" : "painted seeds alone",
            tissues(size, 10, 20, random), {}};
        const core::Document document = documentOf(size, random);
        appendPainted(made, document, 2, false, random);
        appendPainted(made, document, 2, true, random);
        appendSeeds(made, 2, dark);
        appendGrowth(made,
            narrowed(400, told ? std::vector{groupOf(2, dark)} : std::vector<SeedGroup>(), 26));
        cases.push_back(made);
    }
    {
        // Fronts that are wide for their bricks.
        EngineCase made{"two strokes, wide fronts", tissues({64, 50, 40}, 12, 8, random), {}};
        appendSeeds(made, 1, {{5, 20, 20}});
        appendSeeds(made, 1, {{30, 20, 20}});
        appendGrowth(made, narrowed(2000, {groupOf(1, {{5, 20, 20}}), groupOf(1, {{30, 20, 20}})}));
        cases.push_back(made);
    }
    {
        EngineCase made = begun("groups that are refused");
        appendSeeds(made, 3, dark);
        for (const SeedGroup& group :
            {groupOf(0, dark), SeedGroup{.label = 3, .voxels = {{5, 5, 5}, {5, 5, 5}}},
                SeedGroup{.label = 3, .voxels = {{5, 5, 6}, {6, 6, 5}}},
                groupOf(3, {{0, 0, 0}, {50, 0, 0}}), groupOf(3, {{-1, 0, 0}})}) {
            made.steps.push_back(command(core::ProbeSeeds{.seedGroups = {group}}));
            const GrowBurst burst = narrowed(300, {groupOf(3, dark), group});
            made.steps.push_back(BeginGrowth{burst});
            made.steps.push_back(BeginGrowth{narrowed(300, {})});
            made.steps.push_back(command(core::ExtendEdit{core::GrowAnew{burst}}));
            made.steps.push_back(command(core::EndEdit{}));
        }
        cases.push_back(made);
    }
    for (int number = 0; number < randomCount; ++number)
        cases.push_back(daily(randomGroupCase(number)));
    return cases;
}

} // namespace test
