// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/EngineCases.h"

namespace test {

namespace {

using core::MapLabels;

MapLabels inverted(std::uint8_t label, std::uint8_t plane = 0)
{
    MapLabels map{.plane = plane};
    map.becomes[0] = label;
    map.becomes[label] = 0;
    return map;
}

MapLabels swapped(std::uint8_t one, std::uint8_t other)
{
    MapLabels map;
    map.becomes[one] = other;
    map.becomes[other] = one;
    return map;
}

MapLabels allInto(std::uint8_t label)
{
    MapLabels map;
    map.becomes.fill(label);
    return map;
}

/// Any table over the labels that cases hold; the others keep theirs.
MapLabels randomMap(std::uint8_t plane, Random& random)
{
    MapLabels map = random() % 3 == 0 ? inverted(std::uint8_t(randomInt(random, 1, 4)), plane)
                                      : MapLabels{.plane = plane};
    for (std::size_t label = 0; label < 6; ++label) {
        if (random() % 3 == 0)
            map.becomes[label] = std::uint8_t(random() % 4 ? randomInt(random, 0, 5) : 255);
    }
    return map;
}

void appendGrowth(std::vector<EngineStep>& steps, const core::GrowBurst& burst, int count)
{
    steps.push_back(BeginGrowth{burst});
    steps.push_back(command(core::ExtendEdit{core::GrowAdvance{count}}));
    steps.push_back(command(core::EndEdit{}));
}

/// Two segments that grow, one of them over the other; seeds that wait, in free voxels and in what
/// others hold; a barrier.
void appendGrown(std::vector<EngineStep>& steps, const glm::ivec3& size)
{
    core::GrowBurst whole{.lowCode = 0, .highCode = 65535};
    appendWhole(steps, core::SeedPlacement{.label = 1, .voxels = {{0, 0, 0}, size / 2}});
    appendWhole(steps, core::SeedPlacement{.label = 2, .voxels = {{1, 0, 0}, size - 1}});
    appendGrowth(steps, whole, 4);
    appendWhole(steps, core::SeedPlacement{.label = 3, .voxels = {size / 2 + 1}});
    whole.overwritable.set(1);
    appendGrowth(steps, whole, 2);
    core::BarrierListed shut;
    shut.bricks.push_back({.brick = 0});
    for (std::size_t place = 0; place < shut.bricks.back().places.size(); place += 7)
        shut.bricks.back().places.set(place);
    appendWhole(steps, shut);
    appendWhole(steps, core::SeedPlacement{.label = 1, .voxels = {{0, size.y - 1, 0}}});
    appendWhole(steps, core::SeedPlacement{.label = 2, .voxels = {{size.x - 1, 0, 0}}});
}

EngineCase randomMapping(int number)
{
    Random random(std::uint32_t(71000 + number));
    const glm::ivec3 size{
        randomInt(random, 1, 40), randomInt(random, 1, 40), randomInt(random, 1, 40)};
    EngineCase made{
        "random mapping " + QByteArray::number(number), noiseVolume(size, tissueCode, random), {}};
    if (random() % 3)
        made.steps.push_back(command(
            core::SwapBricks{bricksOf(labelBoxes(size, 6, random), core::Field::Labels, 0)}));
    for (int edit = randomInt(random, 4, 12); edit > 0; --edit) {
        const auto plane = std::uint8_t(random() % 6 ? 0 : 1);
        const int what = int(random() % 6);
        switch (what) {
        case 1: {
            core::GrowBurst burst{.plane = plane, .lowCode = 0, .highCode = 65535};
            for (std::size_t label = 1; label < 6; ++label)
                burst.overwritable[label] = random() % 3 == 0;
            appendGrowth(made.steps, burst, 3);
            break;
        }
        case 3: {
            Shrink shrink;
            shrink.shrink.plane = plane;
            shrink.generations = std::uint32_t(random() % 3 + 1);
            made.steps.push_back(shrink);
            break;
        }
        default:
            if (!appendBetween(made.steps, what, plane, size, random))
                appendWhole(made.steps, randomMap(plane, random), {},
                    random() % 5 ? core::Ending::Commit : core::Ending::Rollback);
            break;
        }
    }
    return made;
}

} // namespace

std::vector<EngineCase> mapCases(int randomCount)
{
    std::vector<EngineCase> cases;
    const glm::ivec3 size(33, 18, 20); // no multiple of a brick along any axis
    Random random(9);
    const Codes codes = noiseVolume(size, 65535, random);

    EngineCase nothing{"nothing is mapped", codes, {}};
    appendWhole(nothing.steps, MapLabels{});
    appendWhole(nothing.steps, swapped(1, 2)); // nobody is there
    appendWhole(nothing.steps, allInto(0));
    cases.push_back(nothing);

    EngineCase rim{"inverted up to the rim", codes, {}};
    appendWhole(rim.steps, inverted(1)); // no brick is there: all become full
    appendWhole(rim.steps, inverted(1)); // and empty again
    appendWhole(rim.steps, inverted(255, 1), {}, core::Ending::Rollback);
    appendWhole(rim.steps, inverted(255, 1));
    appendWhole(rim.steps, allInto(2));
    appendWhole(rim.steps, inverted(1)); // nothing is free, nothing is held
    appendWhole(rim.steps, swapped(2, 255));
    rim.steps.push_back(command(core::ProbeVoxels{{{0, 0, 0}, size - 1}}));
    for (int i = 0; i < 5; ++i)
        rim.steps.push_back(Undo{});
    rim.steps.push_back(Redo{});
    cases.push_back(rim);

    // What is carved, muted or not, counts as everything else.
    EngineCase carved{"inverted where all is carved", codes, {}};
    const Bytes whole{
        size, std::vector<std::uint8_t>(std::size_t(size.x) * size.y * size.z, std::uint8_t(255))};
    carved.steps.push_back(command(core::SwapBricks{bricksOf(whole, core::Field::Coverage, 1)}));
    appendWhole(carved.steps, inverted(3));
    carved.steps.push_back(Undo{});
    cases.push_back(carved);

    for (const std::uint8_t label : {1, 2, 3, 4}) {
        EngineCase grown{
            "inverted among members and seeds: " + QByteArray::number(label), codes, {}};
        appendGrown(grown.steps, size);
        appendWhole(grown.steps, inverted(label));
        appendGrowth(grown.steps, {.lowCode = 0, .highCode = 65535}, 3); // what is left goes on
        grown.steps.push_back(Shrink{.shrink = {}, .generations = 4});
        appendWhole(grown.steps, inverted(label));
        for (int i = 0; i < 3; ++i)
            grown.steps.push_back(Undo{});
        appendWhole(grown.steps, swapped(label, 1));
        appendWhole(grown.steps, allInto(label));
        appendWhole(grown.steps, core::EraseLabel{.label = label});
        grown.steps.push_back(Undo{});
        cases.push_back(grown);
    }

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomMapping(number));
    return cases;
}

} // namespace test
