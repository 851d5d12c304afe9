// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/EngineCases.h"

#include "tests/support/cases/RandomEdits.h"

#include <utility>

namespace test {

void appendBurst(
    std::vector<EngineStep>& steps, const core::GrowBurst& burst, int count, core::Ending ending)
{
    steps.push_back(BeginGrowth{burst});
    steps.push_back(command(core::ExtendEdit{core::GrowAdvance{count}}));
    steps.push_back(command(core::EndEdit{ending}));
}

void appendSeeds(std::vector<EngineStep>& steps, core::SeedPlacement seeds, int count,
    const glm::ivec3& size, Random& random)
{
    for (int i = 0; i < count; ++i)
        seeds.voxels.push_back(randomVoxel(random, size));
    appendWhole(steps, std::move(seeds));
}

std::optional<core::GrowthRange> randomGrowthRange(int greatestCode, Random& random)
{
    if (random() % 3 == 0)
        return std::nullopt;
    core::GrowthRange range;
    if (random() % 2) {
        range.lowCode = randomInt(random, 0, greatestCode);
        range.highCode = randomInt(random, greatestCode / 2, greatestCode);
    }
    // 0 too: then growth stays inside other segments.
    for (std::size_t label = 0; label <= 4; ++label)
        range.closed[label] = random() % 4 == 0;
    return range;
}

bool appendBetween(std::vector<EngineStep>& steps, int what, std::uint8_t plane,
    const glm::ivec3& size, Random& random)
{
    switch (what) {
    case 0: {
        core::SeedPlacement seeds{
            .plane = plane, .label = std::uint8_t(randomInt(random, 1, 4)), .voxels = {}};
        appendSeeds(steps, seeds, randomInt(random, 0, 40), size, random);
        return true;
    }
    case 1:
        appendBurst(steps, {.plane = plane, .lowCode = 0, .highCode = 65535}, 3);
        return true;
    case 2:
        steps.push_back(random() % 2 ? EngineStep(Undo{}) : EngineStep(Redo{}));
        return true;
    default:
        return false;
    }
}

std::vector<EngineCase> refusalCases()
{
    using namespace core;
    const glm::ivec3 size(17, 20, 5);
    Random random(7);
    const Document document = randomDocument(size, random, false);
    const DrillCut drill = drillCutOf(randomDrill(document, random), document);
    const SeedPlacement seeds{.plane = 0, .label = 3, .voxels = {{0, 0, 0}, {16, 19, 4}}};
    const BeginEdit beginSeeds{seeds};
    const EndEdit commit{Ending::Commit};
    const EndEdit rollback{Ending::Rollback};
    const GrowBurst growth{.lowCode = 0, .highCode = 65535};
    const ReadBricks readAll{{{Field::SeedWords, 0, 0}, {Field::SeedWords, 0, 3}}};
    const BrickImage image{{Field::Labels, 0, 0},
        std::vector<std::uint8_t>(std::size_t(BrickGrid::voxelsPerBrick), 5)};
    BrickImage cut = image;
    cut.bytes.write().resize(17);
    DrillCut noPitch = drill;
    noPitch.frame.pitch = 0;
    DrillCut noRamp = drill;
    noRamp.frame.rampHalfWidth = 0;
    DrillCut noGap = drill;
    noGap.frame.gapSamples = 0;
    GrowBurst other = growth;
    other.connectivity = 14;
    const ShrinkGrowth tooMuch{.generation = 2, .keep = 3};

    const auto steps = [](std::vector<EngineCommand> commands) {
        std::vector<EngineStep> all;
        for (EngineCommand& known : commands)
            all.push_back(command(std::move(known)));
        return all;
    };
    std::vector<EngineCase> cases;
    const auto add = [&](const char* name, std::vector<EngineCommand> commands) {
        cases.push_back({name, noiseVolume(size, 9, random), steps(std::move(commands))});
    };
    add("extend without an edit",
        {ExtendEdit{GrowAdvance{}}, ExtendEdit{DrillPath{}}, ExtendEdit{GrowPause{}}});
    add("end without an edit", {commit, rollback, beginSeeds, commit, commit});
    add("begin twice", {beginSeeds, beginSeeds, BeginEdit{growth}, commit, readAll});
    add("begin twice, roll back", {beginSeeds, BeginEdit{drill}, rollback, readAll});
    add("shrink to where nothing is open, or something else, or beyond",
        {ExtendEdit{core::ShrinkTo{}}, BeginEdit{growth}, ExtendEdit{core::ShrinkTo{}}, rollback,
            BeginEdit{core::ShrinkGrowth{.generation = 2, .keep = 2}},
            ExtendEdit{core::ShrinkTo{.keep = 3}}, ExtendEdit{core::ShrinkTo{.keep = 1}},
            ExtendEdit{GrowAdvance{}}, commit, readAll});
    add("cut further where nothing is open, or something else, or no step",
        {ExtendEdit{core::CutFurther{}}, BeginEdit{growth}, ExtendEdit{core::CutFurther{2}},
            rollback,
            BeginEdit{core::CutGrowth{
                .how = core::CutGrowth::How::Backwards, .voxels = {{0, 0, 0}}, .steps = 0}},
            BeginEdit{core::CutGrowth{
                .how = core::CutGrowth::How::Backwards, .voxels = {{0, 0, 0}}, .steps = 3}},
            ExtendEdit{core::CutFurther{4}}, commit, readAll});
    add("swap while an edit is open",
        {beginSeeds, SwapBricks{{image}}, commit, ReadBricks{{image.key}}});
    add("bricks that are not there",
        {ReadBricks{{{Field::Labels, 0, 4}}}, ReadBricks{{{Field::Coverage, 1, 4000000000u}}},
            ReadBricks{{{Field(9), 0, 0}}}, SwapBricks{{image, {{Field::Labels, 0, 4}, {}}}},
            ReadBricks{{image.key}}});
    add("images cut short", {SwapBricks{{cut}}, ReadBricks{{cut.key}}});
    add("voxels outside",
        {ProbeVoxels{{{0, 0, 0}, {17, 0, 0}}}, ProbeVoxels{{{0, -1, 0}}},
            BeginEdit{SeedPlacement{.label = 1, .voxels = {{0, 0, 0}, {0, 0, 5}}}}, commit,
            readAll});
    add("label 0", {BeginEdit{SeedPlacement{.label = 0, .voxels = {{0, 0, 0}}}}, commit});
    add("connectivity",
        {beginSeeds, commit, BeginEdit{other}, ExtendEdit{GrowAdvance{}}, commit, readAll});
    add("shrinking to more than there is", {BeginEdit{tooMuch}, commit, readAll});
    add("extensions of another kind",
        {beginSeeds, ExtendEdit{GrowAdvance{}}, commit, BeginEdit{growth}, ExtendEdit{DrillPath{}},
            ExtendEdit{GrowAdvance{2}}, commit, BeginEdit{drill}, ExtendEdit{GrowPause{}}, commit});
    add("frames",
        {BeginEdit{noPitch}, BeginEdit{noRamp}, BeginEdit{noGap}, commit, BeginEdit{drill},
            rollback});
    add("opacities",
        {PickVoxels{.rays = {{.samples = 3}}, .seenBy = SeenBy::Opacity},
            PickVoxels{.rays = {{.samples = 3}}, .seenBy = SeenBy::Surface}});
    return cases;
}

} // namespace test
