// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/EngineCases.h"
#include "tests/support/scenes/ToleranceScene.h"

#include "core/growth/SeedWord.h"

#include <array>

namespace test {

namespace {

using namespace core;
namespace seedWord = core::seedWord;

void whole(
    ToleranceScene& scene, const EngineEdit& edit, std::vector<EngineExtension> extensions = {})
{
    scene.commands.push_back(BeginEdit{edit});
    for (EngineExtension& extension : extensions)
        scene.commands.push_back(ExtendEdit{std::move(extension)});
    scene.commands.push_back(EndEdit{});
}

Codes randomCodes(const glm::ivec3& size, Random& random)
{
    switch (random() % 4) {
    case 0:
        return noiseVolume(size, random() % 2 ? 12 : 65535, random);
    case 1:
        return shells(size);
    default:
        return balls(size, randomInt(random, 2, 6), random);
    }
}

/// Words and labels as strokes, growths and imports leave them, and some that only a file could.
SwapBricks randomState(const glm::ivec3& size, Random& random)
{
    const BrickGrid grid{size};
    SwapBricks swap;
    for (int brick = 0; brick < grid.brickCount(); ++brick) {
        BrickImage labels{{Field::Labels, 0, std::uint32_t(brick)}, {}};
        BrickImage words{{Field::SeedWords, 0, std::uint32_t(brick)}, {}};
        for (int offset = 0; offset < BrickGrid::voxelsPerBrick; ++offset) {
            const std::array<std::uint8_t, 4> held{1, 2, 3, 255};
            const std::uint8_t label = random() % 9 ? 0 : held[random() % held.size()];
            std::uint32_t word = seedWord::unvisited;
            switch (random() % 40) {
            case 0:
                word = seedWord::barrier;
                break;
            case 1:
                word = seedWord::member(1 + random() % 3, label, random() % 32);
                break;
            case 2:
                word = seedWord::pendingSeed(label == 0 ? 2 : label);
                break;
            case 3:
                word = seedWord::member(0, label, seedWord::seedDirection);
                break;
            default:
                break;
            }
            const glm::ivec3 voxel = grid.brickPosition(brick) * BrickGrid::side
                + glm::ivec3(offset & 15, offset >> 4 & 15, offset >> 8);
            const bool inside = glm::all(glm::lessThan(voxel, size));
            const bool sound = inside && (word == seedWord::barrier || seedWord::label(word) != 0);
            labels.bytes.write().push_back(inside ? label : 0);
            for (int byte = 0; byte < 4; ++byte)
                words.bytes.write().push_back(
                    std::uint8_t((sound ? word : seedWord::unvisited) >> (8 * byte)));
        }
        swap.bricks.push_back(std::move(labels));
        swap.bricks.push_back(std::move(words));
    }
    return swap;
}

} // namespace

ToleranceScene randomToleranceScene(const glm::ivec3& size, Random& random)
{
    ToleranceScene scene{.codes = randomCodes(size, random)};
    if (random() % 2)
        scene.commands.push_back(randomState(size, random));
    SeedPlacement seeds{.label = 2};
    for (int i = randomInt(random, 1, 3); i > 0; --i)
        seeds.voxels.push_back(randomVoxel(random, size));
    whole(scene, seeds);
    const int code = scene.codes.at(seeds.voxels.front());
    // What has grown before does not count, nor what another segment has.
    if (random() % 2)
        whole(scene, GrowBurst{.lowCode = code - 9, .highCode = code + 200, .generation = 3},
            {GrowAdvance{int(random() % 6)}});

    ToleranceRule& rule = scene.rule;
    rule.label = 2;
    rule.connectivity = std::array<int, 3>{6, 18, 26}[random() % 3];
    if (random() % 2)
        rule.overwritable.set(1).set(255);
    if (random() % 3 == 0) {
        rule.limits.boxed = true;
        const glm::ivec3 a = randomVoxel(random, size);
        const glm::ivec3 b = randomVoxel(random, size);
        rule.limits.boxFrom = glm::min(a, b);
        rule.limits.boxTo = glm::max(a, b);
    }
    if (random() % 3 == 0) {
        rule.limits.gradientWeights = glm::ivec3(512, 1024, 300);
        rule.limits.gradient = randomInt(random, 0, 900);
    }
    if (random() % 3 == 0) {
        rule.limits.onlyVisible = true;
        Bytes coverage{size, std::vector<std::uint8_t>(scene.codes.values.size())};
        for (std::uint8_t& value : coverage.values)
            value = random() % 5 ? 0 : 200;
        scene.commands.push_back(SwapBricks{bricksOf(coverage, Field::Coverage, 1)});
    }
    Random ranges(std::uint32_t(46000 + code));
    if (ranges() % 2)
        rule.range = randomGrowthRange(tissueCode, ranges).value_or(core::GrowthRange());
    return scene;
}

namespace {

EngineCommand wherever(const glm::ivec3& size)
{
    ProbeVoxels probe;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                probe.voxels.emplace_back(x, y, z);
    return probe;
}

/// Traced, told, dropped by an edit, traced again: with what came of it in between.
EngineCase randomTracing(int number)
{
    Random random(std::uint32_t(42000 + number));
    const bool small = random() % 4 == 0;
    const glm::ivec3 size{randomInt(random, 1, small ? 9 : 50), randomInt(random, 1, 40),
        randomInt(random, 1, small ? 40 : 34)};
    ToleranceScene scene = randomToleranceScene(size, random);
    EngineCase made{"random tracing " + QByteArray::number(number), scene.codes, {}};
    for (EngineCommand& command : scene.commands)
        made.steps.emplace_back(std::move(command));
    const auto trace = [&] {
        made.steps.emplace_back(EngineCommand(TraceTolerance{scene.rule}));
        made.steps.emplace_back(wherever(size));
    };
    trace();
    for (int round = randomInt(random, 1, 4); round > 0; --round) {
        switch (random() % 6) {
        case 0: // no other seeds, no other walls
            made.steps.emplace_back(BeginGrowth{GrowBurst{.lowCode = 0, .highCode = 65535}});
            made.steps.emplace_back(EngineCommand(ExtendEdit{GrowAdvance{2}}));
            made.steps.emplace_back(EngineCommand(EndEdit{Ending::Rollback}));
            break;
        case 1:
            appendWhole(made.steps,
                SeedPlacement{.label = std::uint8_t(random() % 2 ? 2 : 3),
                    .voxels = {randomVoxel(random, size)}});
            break;
        case 2:
            scene.rule.connectivity = scene.rule.connectivity == 6 ? 26 : 6;
            break;
        case 3:
            made.steps.emplace_back(EngineCommand(MuteLayers{std::bitset<256>(random() % 2 * 2)}));
            break;
        case 4:
            made.steps.emplace_back(EngineCommand(DropTolerance{}));
            break;
        default:
            made.steps.emplace_back(Undo{});
            break;
        }
        made.steps.emplace_back(
            EngineCommand(ProbeVoxels{{randomVoxel(random, size), randomVoxel(random, size)}}));
        trace();
    }
    return made;
}

} // namespace

std::vector<EngineCase> toleranceCases(int randomCount)
{
    std::vector<EngineCase> cases;
    Random random(42);

    EngineCase maze{"tracing along a corridor", spiralCorridor({49, 49, 9}), {}};
    appendWhole(maze.steps, SeedPlacement{.label = 2, .voxels = {{0, 0, 0}}});
    maze.steps.emplace_back(EngineCommand(TraceTolerance{{.label = 2}}));
    maze.steps.emplace_back(wherever({49, 49, 9}));
    cases.push_back(maze);

    // Hundreds of rounds to rest in one brick.
    const glm::ivec3 zigzagSize(32, 14, 15);
    for (const int connectivity : {18, 26}) {
        EngineCase zigzag{
            "tracing along a zigzag, " + QByteArray::number(connectivity) + " neighbours",
            zigzagCorridor(zigzagSize), {}};
        appendWhole(zigzag.steps, SeedPlacement{.label = 2, .voxels = {{0, 0, 0}}});
        zigzag.steps.emplace_back(
            EngineCommand(TraceTolerance{{.label = 2, .connectivity = connectivity}}));
        zigzag.steps.emplace_back(wherever(zigzagSize));
        cases.push_back(zigzag);
    }

    EngineCase refused{"tracing that is refused", noiseVolume({20, 20, 20}, 9, random), {}};
    refused.steps.emplace_back(EngineCommand(TraceTolerance{{.label = 2}})); // no seeds
    appendWhole(refused.steps, SeedPlacement{.label = 2, .voxels = {{3, 3, 3}}});
    refused.steps.emplace_back(EngineCommand(TraceTolerance{{.label = 2}}));
    refused.steps.emplace_back(wherever({20, 20, 20}));
    refused.steps.emplace_back(EngineCommand(TraceTolerance{{.label = 0}}));
    refused.steps.emplace_back(wherever({20, 20, 20})); // and so none stands
    refused.steps.emplace_back(
        EngineCommand(TraceTolerance{{.label = 2, .limits = {.difference = 4}}}));
    refused.steps.emplace_back(EngineCommand(BeginEdit{SeedPlacement{.label = 1}}));
    refused.steps.emplace_back(EngineCommand(TraceTolerance{{.label = 2}})); // an edit is open
    refused.steps.emplace_back(EngineCommand(EndEdit{}));
    refused.steps.emplace_back(wherever({20, 20, 20}));
    cases.push_back(refused);

    EngineCase extremes{"tracing from darkest to brightest", checkerboard({20, 18, 17}), {}};
    for (std::size_t i = 0; i < extremes.codes.values.size(); ++i)
        extremes.codes.values[i] = std::uint16_t(i % 7 == 0 ? 65535 - i % 5 : i % 3);
    appendWhole(extremes.steps, SeedPlacement{.label = 2, .voxels = {{1, 0, 0}}});
    extremes.steps.emplace_back(EngineCommand(TraceTolerance{{.label = 2, .connectivity = 26}}));
    extremes.steps.emplace_back(wherever({20, 18, 17}));
    cases.push_back(extremes);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomTracing(number));
    return cases;
}

} // namespace test
