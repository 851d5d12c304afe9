// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"

#include <algorithm>
#include <array>

namespace test {

namespace {

using core::GrowAdvance;
using core::GrowAnew;
using core::GrowBurst;
using core::GrowOpening;

/// A growth whose interval is moved to and fro, with barriers that come and go; one label, or three
/// that compete.
EngineCase randomMoves(int number)
{
    Random random(std::uint32_t(27000 + number));
    const glm::ivec3 size{
        randomInt(random, 4, 36), randomInt(random, 4, 36), randomInt(random, 4, 36)};
    const core::Document document = randomDocument(size, random, false);
    EngineCase made{"random moves of the interval " + QByteArray::number(number),
        random() % 3 ? balls(size, 6, random) : noiseVolume(size, tissueCode, random), {}};
    Random ranges(std::uint32_t(43000 + number));
    const int labels = number % 3 == 2 ? 3 : 1;
    const auto sketch = [&](int label) {
        core::SeedPlacement seeds{.label = std::uint8_t(label)};
        appendSeeds(made.steps, seeds, randomInt(random, 1, 3), size, random);
    };
    if (random() % 2) { // the label holds some voxels already, and others hold some
        Bytes held{size, std::vector<std::uint8_t>(made.codes.values.size(), 0)};
        for (std::uint8_t& label : held.values)
            label = random() % 9 ? std::uint8_t(0) : std::uint8_t(randomInt(random, 1, 4));
        made.steps.push_back(command(core::SwapBricks{bricksOf(held, core::Field::Labels, 0)}));
    }
    for (int label = 1; label <= labels; ++label)
        sketch(label);
    const int connectivity = std::array<int, 3>{6, 18, 26}[random() % 3];
    const auto burstNow = [&] {
        GrowBurst burst{.lowCode = randomInt(random, 0, 500),
            .highCode = randomInt(random, 500, tissueCode),
            .connectivity = random() % 8 ? connectivity : 6,
            .opening = std::array<GrowOpening, 6>{GrowOpening::Narrow, GrowOpening::Narrow,
                GrowOpening::Narrow, GrowOpening::Narrow, GrowOpening::Restart,
                GrowOpening::GoOn}[random() % 6]};
        burst.overwritable[4] = random() % 4 == 0;
        burst.lockedLabels[3] = random() % 6 == 0;
        if (number % 2)
            burst.range = randomGrowthRange(tissueCode, ranges);
        return burst;
    };
    for (int move = 0; move < 50; ++move) {
        if (random() % 12 == 0)
            sketch(randomInt(random, 1, labels));
        if (random() % 8 == 0) {
            core::BarrierStroke stroke{.path = randomPath(document, random)};
            stroke.erase = random() % 3 == 0;
            if (const auto barrier = core::paintBarrier(stroke, document)) {
                core::PaintBarrier shut = *barrier;
                shut.lockedLabels[2] = random() % 5 == 0;
                appendWhole(made.steps, shut,
                    {core::CapsulePath{
                        core::capsules(stroke.path, document.volumes.front().geometry)}});
            }
        }
        made.steps.push_back(BeginGrowth{burstNow()});
        const auto advance = [&] {
            const int steps = random() % 3 ? GrowAdvance::toClosure : randomInt(random, 0, 6);
            made.steps.push_back(command(core::ExtendEdit{GrowAdvance{steps}}));
        };
        advance();
        for (int again = int(random() % 3); again > 0 && random() % 3 == 0; --again) {
            made.steps.push_back(command(core::ExtendEdit{GrowAnew{burstNow()}}));
            advance();
        }
        made.steps.push_back(
            command(core::EndEdit{random() % 9 ? core::Ending::Commit : core::Ending::Rollback}));
        if (random() % 9 == 0)
            made.steps.push_back(Shrink{.shrink = {}, .generations = 3});
        if (random() % 6 == 0)
            made.steps.push_back(Undo{});
        if (random() % 9 == 0)
            made.steps.push_back(Redo{});
    }
    return made;
}

/// An interval that is dragged over a growth of one label: bursts that begin anew and differ in the
/// interval alone, some of them guarded.
EngineCase randomDrags(int number)
{
    Random random(std::uint32_t(28000 + number));
    const glm::ivec3 size{
        randomInt(random, 8, 40), randomInt(random, 8, 40), randomInt(random, 8, 40)};
    const int greatest = number % 2 ? 30 : tissueCode;
    EngineCase made{"an interval that is dragged " + QByteArray::number(number),
        number % 3 ? noiseVolume(size, greatest, random) : balls(size, 6, random), {}};
    if (random() % 2)
        made.steps.push_back(command(
            core::SwapBricks{bricksOf(labelBoxes(size, 5, random), core::Field::Labels, 0)}));
    core::SeedPlacement seeds{.label = 1};
    appendSeeds(made.steps, seeds, randomInt(random, 1, 3), size, random);
    GrowBurst burst{.connectivity = std::array<int, 3>{6, 18, 26}[random() % 3]};
    burst.overwritable[2] = random() % 2;
    burst.overwritable[4] = random() % 2;
    burst.lockedLabels[3] = true;
    Random ranges(std::uint32_t(44000 + number));
    if (number % 2)
        burst.range = randomGrowthRange(greatest, ranges);
    const auto move = [&] {
        burst.lowCode = randomInt(random, 0, greatest / 2);
        burst.highCode = randomInt(random, greatest / 2, greatest);
        burst.guard.reset();
        if (random() % 4 == 0)
            burst.guard = core::GuardRule{.excess = 4, .window = 5};
    };
    for (int drag = 0; drag < 6; ++drag) {
        move();
        made.steps.push_back(BeginGrowth{burst});
        burst.opening = GrowOpening::Narrow; // from the second on
        for (int event = randomInt(random, 0, 8); event >= 0; --event) {
            made.steps.push_back(command(core::ExtendEdit{
                GrowAdvance{random() % 4 ? GrowAdvance::toClosure : randomInt(random, 0, 5)}}));
            if ((drag + event) % 2 == 0) {
                made.steps.push_back(Settle{});
                made.steps.push_back(command(core::CompareGrowth{.keep = event % 3 != 0}));
            }
            move();
            if (event > 0)
                made.steps.push_back(command(core::ExtendEdit{GrowAnew{burst}}));
        }
        made.steps.push_back(
            command(core::EndEdit{random() % 5 ? core::Ending::Commit : core::Ending::Rollback}));
        if (random() % 4 == 0)
            made.steps.push_back(Undo{});
        if (random() % 4 == 0)
            made.steps.push_back(Redo{});
        if (random() % 3 == 0)
            appendSeeds(made.steps, seeds, 1, size, random);
    }
    return made;
}

} // namespace

std::vector<EngineCase> intervalCases(int randomCount)
{
    std::vector<EngineCase> cases;
    for (const GrowOpening opening : {GrowOpening::Narrow, GrowOpening::Restart}) {
        // A long corridor whose middle fails: all beyond it leaves, and comes back.
        EngineCase corridor{opening == GrowOpening::Narrow ? "a corridor that is shut and opened"
                                                           : "a corridor that is grown anew",
            spiralCorridor({40, 17, 5}), {}};
        corridor.codes.at({3, 0, 0}) = tissueCode / 2;
        appendWhole(corridor.steps, core::SeedPlacement{.label = 9, .voxels = {{0, 0, 0}}});
        for (const int low :
            {tissueCode / 4, tissueCode / 2 + 1, tissueCode / 4, tissueCode + 1, tissueCode / 4}) {
            GrowBurst burst{.lowCode = low, .highCode = 65535, .opening = opening};
            corridor.steps.push_back(BeginGrowth{burst});
            corridor.steps.push_back(command(core::ExtendEdit{GrowAdvance{}}));
            corridor.steps.push_back(command(core::EndEdit{}));
        }
        for (int i = 0; i < 5; ++i)
            corridor.steps.push_back(Undo{});
        for (int i = 0; i < 5; ++i)
            corridor.steps.push_back(Redo{});
        cases.push_back(corridor);
    }
    EngineCase refused{"a growth begun anew that is refused", constantVolume({9, 9, 9}, 7), {}};
    appendWhole(refused.steps, core::SeedPlacement{.label = 9, .voxels = {{0, 0, 0}}});
    const GrowBurst all{.lowCode = 0, .highCode = 65535};
    GrowBurst odd = all;
    odd.connectivity = 7;
    GrowBurst elsewhere = all;
    elsewhere.plane = 1;
    refused.steps.push_back(command(core::CompareGrowth{})); // with nothing
    refused.steps.push_back(BeginGrowth{all});
    refused.steps.push_back(command(core::ExtendEdit{GrowAdvance{2}}));
    refused.steps.push_back(command(core::ExtendEdit{GrowAnew{odd}}));
    refused.steps.push_back(command(core::ExtendEdit{GrowAnew{elsewhere}}));
    refused.steps.push_back(command(core::EndEdit{}));
    appendWhole(refused.steps, core::EraseLabel{.label = 1}, {GrowAnew{all}});
    cases.push_back(refused);
    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomMoves(number));
    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomDrags(number));
    return cases;
}

} // namespace test
