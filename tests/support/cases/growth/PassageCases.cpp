// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/cases/growth/GrowthAnswers.h"

#include <algorithm>
#include <array>

namespace test {

namespace {

using core::GrowAdvance;
using core::GrowAnew;
using core::GrowBurst;
using core::GrowOpening;

/// Mostly balls of few voxels; now and then one that reaches as far as any may.
core::Passage randomPassage(Random& random)
{
    core::Passage passage;
    for (int axis = 0; axis < 3; ++axis)
        passage.spacing[axis] = random() % 2 ? 16 : randomInt(random, 16, 60);
    const int half = randomInt(random, 15, random() % 8 ? 50 : 248);
    passage.reach = half * half;
    return passage;
}

/// Rooms, walls and holes of all sizes.
Codes randomRooms(const glm::ivec3& size, Random& random)
{
    Codes codes = random() % 3 ? balls(size, randomInt(random, 2, 9), random)
                               : constantVolume(size, std::uint16_t(tissueCode / 2));
    for (int i = randomInt(random, 1, 14); i > 0; --i) {
        const glm::ivec3 from = randomVoxel(random, size);
        glm::ivec3 to(0);
        for (int axis = 0; axis < 3; ++axis)
            to[axis] = std::min(from[axis] + randomInt(random, 0, 9), size[axis] - 1);
        const auto code = std::uint16_t(random() % 3 ? tissueCode / 2 : 0);
        for (int z = from.z; z <= to.z; ++z)
            for (int y = from.y; y <= to.y; ++y)
                for (int x = from.x; x <= to.x; ++x)
                    codes.at({x, y, z}) = code;
    }
    return codes;
}

EngineCase randomPassage(int number)
{
    Random random(std::uint32_t(91000 + number));
    glm::ivec3 size{randomInt(random, 6, 44), randomInt(random, 6, 44), randomInt(random, 6, 44)};
    if (random() % 5 == 0)
        size[int(random() % 3)] = randomInt(random, 1, 3); // as a picture is
    const core::Document document = randomDocument(size, random, false);
    EngineCase made{"random passages " + QByteArray::number(number), randomRooms(size, random), {}};
    const int labels = number % 2 ? 1 : randomInt(random, 2, 3);
    const auto sketch = [&](int label) {
        core::SeedPlacement seeds{.label = std::uint8_t(label)};
        appendSeeds(made.steps, seeds, randomInt(random, 1, 4), size, random);
    };
    if (random() % 3 == 0) {
        Bytes held{size, std::vector<std::uint8_t>(made.codes.values.size(), 0)};
        for (int i = 0; i < 5; ++i) {
            const glm::ivec3 from = randomVoxel(random, size);
            const auto label = std::uint8_t(randomInt(random, 1, 4));
            for (int x = from.x; x < std::min(from.x + 5, size.x); ++x)
                for (int y = from.y; y < std::min(from.y + 4, size.y); ++y)
                    held.at({x, y, from.z}) = label;
        }
        made.steps.push_back(command(core::SwapBricks{bricksOf(held, core::Field::Labels, 0)}));
    }
    for (int label = 1; label <= labels; ++label)
        sketch(label);
    const int connectivity = std::array<int, 3>{6, 18, 26}[random() % 3];
    const core::Passage usual = randomPassage(random);
    Random ranges(std::uint32_t(47000 + number));
    const auto burstNow = [&] {
        GrowBurst burst{.lowCode = randomInt(random, 0, 500),
            .highCode = randomInt(random, 500, tissueCode),
            .connectivity = connectivity};
        burst.opening = random() % 2 ? GrowOpening::GoOn : GrowOpening::Restart;
        burst.limits.passage = random() % 4 ? usual : randomPassage(random);
        if (random() % 8 == 0)
            burst.limits.passage = {};
        if (random() % 5 == 0)
            burst.limits.majority = randomInt(random, 2, 20);
        if (random() % 6 == 0)
            burst.limits.sigmas256 = randomInt(random, 200, 2000);
        if (random() % 6 == 0) {
            burst.limits.boxed = true;
            burst.limits.boxFrom = randomVoxel(random, size) - 8;
            burst.limits.boxTo = burst.limits.boxFrom + 20;
        }
        if (random() % 6 == 0)
            burst.limits.difference = randomInt(random, 100, tissueCode);
        if (random() % 7 == 0)
            burst.guard = core::GuardRule{.factor256 = 300, .excess = 20, .window = 10};
        burst.overwritable[4] = random() % 3 == 0;
        burst.overwritable[1] = random() % 4 == 0;
        burst.lockedLabels[3] = random() % 5 == 0;
        if (number % 2)
            burst.range = randomGrowthRange(tissueCode, ranges);
        return burst;
    };
    for (int move = randomInt(random, 3, 8); move > 0; --move) {
        if (random() % 4 == 0)
            sketch(randomInt(random, 1, labels));
        if (random() % 4 == 0) {
            const core::BarrierStroke stroke{
                .path = randomPath(document, random), .erase = random() % 3 == 0};
            if (const auto barrier = core::paintBarrier(stroke, document))
                appendWhole(made.steps, *barrier,
                    {core::CapsulePath{
                        core::capsules(stroke.path, document.volumes.front().geometry)}});
        }
        made.steps.push_back(BeginGrowth{burstNow()});
        const auto advance = [&] {
            const int steps = random() % 2 ? GrowAdvance::toClosure : randomInt(random, 0, 20);
            made.steps.push_back(command(core::ExtendEdit{GrowAdvance{steps}}));
        };
        advance();
        if (random() % 3 == 0)
            advance();
        if (random() % 4 == 0) {
            made.steps.push_back(command(core::ExtendEdit{GrowAnew{burstNow()}}));
            advance();
        }
        made.steps.push_back(
            command(core::EndEdit{random() % 9 ? core::Ending::Commit : core::Ending::Rollback}));
        if (random() % 5 == 0)
            made.steps.push_back(Shrink{.shrink = {}, .generations = 3});
        if (random() % 5 == 0)
            made.steps.push_back(Undo{});
    }
    return made;
}

EngineCase grownPassage(const QByteArray& name, Codes codes, const std::vector<glm::ivec3>& seeds,
    const GrowBurst& burst)
{
    EngineCase made{name, std::move(codes), {}};
    appendWhole(made.steps, core::SeedPlacement{.label = 7, .voxels = seeds});
    made.steps.push_back(BeginGrowth{burst});
    made.steps.push_back(command(core::ExtendEdit{GrowAdvance{2}}));
    made.steps.push_back(command(core::ExtendEdit{GrowAdvance{}}));
    made.steps.push_back(command(core::EndEdit{}));
    made.steps.push_back(Undo{});
    made.steps.push_back(Redo{});
    return made;
}

GrowBurst rolling(int half, const glm::ivec3& spacing, int connectivity = 6)
{
    GrowBurst burst{.lowCode = 1, .highCode = 65535, .connectivity = connectivity};
    burst.limits.passage = {.spacing = spacing, .reach = half * half};
    return burst;
}

} // namespace

std::vector<EngineCase> passageCases(int randomCount)
{
    Random random(5151);
    std::vector<EngineCase> cases;
    const glm::ivec3 size(38, 21, 35);
    for (const int half : {0, 15, 16, 22, 23, 32, 80, 248})
        cases.push_back(
            grownPassage("a ball of half width " + QByteArray::number(half), balls(size, 7, random),
                {{19, 10, 17}, {0, 0, 0}, {37, 20, 34}}, rolling(half, glm::ivec3(16), 18)));
    for (const glm::ivec3& flat :
        {glm::ivec3(40, 40, 1), glm::ivec3(1, 40, 40), glm::ivec3(33, 1, 1)})
        cases.push_back(grownPassage("one voxel thick", constantVolume(flat, 5), {flat / 2},
            rolling(40, glm::ivec3(16), 26)));
    // At the far ends a brick holds one voxel only, for which all beyond stands.
    const glm::ivec3 odd(33, 17, 49);
    Codes corner = constantVolume(odd, 5);
    corner.at({32, 16, 40}) = 0;
    cases.push_back(
        grownPassage("beyond the volume", corner, {{16, 8, 20}}, rolling(56, {16, 20, 33})));
    for (const int connectivity : {6, 18, 26}) {
        Codes wall = constantVolume(size, 5);
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                wall.at({18, y, z}) = std::abs(y - 10) + std::abs(z - 17) < 3 ? 5 : 0;
        cases.push_back(grownPassage(
            "a hole in a wall", wall, {{3, 10, 17}}, rolling(48, glm::ivec3(16), connectivity)));
    }
    EngineCase many{"more labels than a word", constantVolume({70, 20, 20}, 5), {}};
    for (int label = 1; label <= 40; ++label)
        appendWhole(many.steps,
            core::SeedPlacement{
                .label = std::uint8_t(6 * label), .voxels = {randomVoxel(random, {70, 20, 20})}});
    many.steps.push_back(BeginGrowth{rolling(33, glm::ivec3(16))});
    many.steps.push_back(command(core::ExtendEdit{GrowAdvance{}}));
    many.steps.push_back(command(core::EndEdit{}));
    cases.push_back(many);

    EngineCase refused{"passages that are not sound", constantVolume({9, 9, 9}, 5), {}};
    appendWhole(refused.steps, core::SeedPlacement{.label = 1, .voxels = {{4, 4, 4}}});
    for (const core::Passage& passage : {core::Passage{.spacing = glm::ivec3(16), .reach = -1},
             core::Passage{.spacing = glm::ivec3(16), .reach = 65535},
             core::Passage{.spacing = {16, 0, 16}, .reach = 100},
             core::Passage{.spacing = {16, 16, 257}, .reach = 100},
             core::Passage{.spacing = {2, 16, 16}, .reach = 1024}}) {
        GrowBurst burst = rolling(0, glm::ivec3(16));
        burst.limits.passage = passage;
        refused.steps.push_back(command(core::BeginEdit{burst}));
    }
    GrowBurst narrowed = rolling(40, glm::ivec3(16));
    narrowed.opening = GrowOpening::Narrow;
    refused.steps.push_back(command(core::BeginEdit{narrowed}));
    GrowBurst untold = rolling(40, glm::ivec3(16));
    untold.tellsHeld = false;
    refused.steps.push_back(command(core::BeginEdit{untold}));
    cases.push_back(refused);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(daily(randomPassage(number)));
    return cases;
}

} // namespace test
