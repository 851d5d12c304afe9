// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/EngineCases.h"

namespace test {

namespace {

using core::BarrierListed;

using Places = std::bitset<core::BrickGrid::voxelsPerBrick>;

/// Every voxel of every brick by a rule, those beyond the volume's rim too.
template <class Rule>
BarrierListed everywhere(const glm::ivec3& size, bool erase, std::bitset<256> frozen, Rule rule)
{
    BarrierListed edit{.erase = erase, .lockedLabels = frozen};
    for (int brick = 0; brick < core::BrickGrid{size}.brickCount(); ++brick) {
        Places places;
        for (std::size_t voxel = 0; voxel < places.size(); ++voxel)
            places[voxel] = rule(voxel);
        edit.bricks.push_back({.brick = std::uint32_t(brick), .places = places});
    }
    return edit;
}

core::GrowBurst taking(std::initializer_list<std::size_t> labels, int connectivity = 6)
{
    core::GrowBurst burst{.lowCode = 0, .highCode = 65535, .connectivity = connectivity};
    for (const std::size_t label : labels)
        burst.overwritable.set(label);
    return burst;
}

BarrierListed randomList(const glm::ivec3& size, std::uint8_t plane, Random& random)
{
    BarrierListed edit{.plane = plane, .erase = random() % 3 == 0};
    for (std::size_t label = 1; label < 5; ++label)
        edit.lockedLabels[label] = random() % 4 == 0;
    const unsigned sparse = random() % 2 ? 2 : 40;
    for (int brick = 0; brick < core::BrickGrid{size}.brickCount(); ++brick) {
        if (random() % 3 == 0)
            continue;
        Places places;
        for (std::size_t voxel = 0; voxel < places.size(); ++voxel)
            places[voxel] = random() % sparse == 0;
        edit.bricks.push_back({.brick = std::uint32_t(brick), .places = places});
    }
    return edit;
}

core::GrowBurst randomBurst(std::uint8_t plane, Random& random)
{
    core::GrowBurst burst = taking({}, std::array<int, 3>{6, 18, 26}[random() % 3]);
    burst.plane = plane;
    burst.opening =
        std::array<core::GrowOpening, 4>{core::GrowOpening::GoOn, core::GrowOpening::GoOn,
            core::GrowOpening::Narrow, core::GrowOpening::Restart}[random() % 4];
    burst.lowCode = randomInt(random, 0, 300);
    for (std::size_t label = 1; label < 6; ++label)
        burst.overwritable[label] = random() % 2;
    return burst;
}

EngineCase randomBarriers(int number)
{
    Random random(std::uint32_t(71000 + number));
    const glm::ivec3 size{
        randomInt(random, 1, 40), randomInt(random, 1, 40), randomInt(random, 1, 40)};
    EngineCase made{
        "random shutting " + QByteArray::number(number), noiseVolume(size, tissueCode, random), {}};
    if (random() % 3)
        made.steps.push_back(command(
            core::SwapBricks{bricksOf(labelBoxes(size, 6, random), core::Field::Labels, 0)}));
    for (int edit = randomInt(random, 5, 14); edit > 0; --edit) {
        const auto plane = std::uint8_t(random() % 6 ? 0 : 1);
        switch (random() % 7) {
        case 0:
        case 1: {
            core::SeedPlacement seeds{
                .plane = plane, .label = std::uint8_t(randomInt(random, 1, 4)), .voxels = {}};
            appendSeeds(made.steps, seeds, randomInt(random, 0, 20), size, random);
            break;
        }
        case 2:
        case 3:
            appendBurst(made.steps, randomBurst(plane, random), randomInt(random, 0, 8));
            break;
        case 4:
            made.steps.push_back(random() % 2 ? EngineStep(Undo{}) : EngineStep(Redo{}));
            break;
        default:
            appendWhole(made.steps, randomList(size, plane, random), {},
                random() % 5 ? core::Ending::Commit : core::Ending::Rollback);
            break;
        }
    }
    return made;
}

} // namespace

std::vector<EngineCase> barrierCases(int randomCount)
{
    std::vector<EngineCase> cases;
    const glm::ivec3 size(33, 18, 20); // no multiple of a brick along any axis
    Random random(11);
    const Codes codes = noiseVolume(size, 65535, random);
    const auto all = [](std::size_t) { return true; };
    const auto none = [](std::size_t) { return false; };
    const auto byTurns = [](std::size_t voxel) { return voxel % 2 == 0; };

    EngineCase nothing{"nothing is shut", codes, {}};
    appendWhole(nothing.steps, BarrierListed{});
    appendWhole(nothing.steps, everywhere(size, false, {}, none));
    appendWhole(nothing.steps, everywhere(size, true, {}, all));
    cases.push_back(nothing);

    EngineCase rim{"shut up to the rim", codes, {}};
    appendWhole(rim.steps, everywhere(size, false, {}, byTurns));
    appendWhole(rim.steps, everywhere(size, false, {}, byTurns)); // nothing is left to do
    appendWhole(rim.steps, everywhere(size, false, {}, all), {}, core::Ending::Rollback);
    appendWhole(rim.steps, everywhere(size, false, {}, all));
    appendWhole(rim.steps, core::SeedPlacement{.label = 1, .voxels = {{3, 3, 3}}});
    appendWhole(rim.steps, everywhere(size, true, {}, byTurns));
    appendWhole(rim.steps, core::SeedPlacement{.label = 1, .voxels = {{2, 3, 3}, {3, 3, 3}}});
    appendBurst(rim.steps, taking({}, 26), 40);
    for (int i = 0; i < 4; ++i)
        rim.steps.push_back(Undo{});
    rim.steps.push_back(Redo{});
    cases.push_back(rim);

    // Members that took voxels from others, that grew over their own, seeds that wait; some locked.
    for (const std::size_t frozen : {0, 1, 2, 3}) {
        EngineCase grown{
            "shut among members and seeds, frozen " + QByteArray::number(int(frozen)), codes, {}};
        grown.steps.push_back(command(
            core::SwapBricks{bricksOf(labelBoxes(size, 8, random), core::Field::Labels, 0)}));
        appendWhole(grown.steps, core::SeedPlacement{.label = 1, .voxels = {{0, 0, 0}, size / 2}});
        appendWhole(grown.steps, core::SeedPlacement{.label = 2, .voxels = {{1, 0, 0}, size - 1}});
        appendBurst(grown.steps, taking({1, 2, 3, 4}, 18), 6);
        appendWhole(grown.steps, core::SeedPlacement{.label = 3, .voxels = {{size.x - 1, 0, 0}}});
        std::bitset<256> stays;
        stays[frozen] = true;
        appendWhole(grown.steps, everywhere(size, false, stays, byTurns));
        appendBurst(grown.steps, taking({1, 2, 3, 4}), 3);
        grown.steps.push_back(Undo{});
        grown.steps.push_back(Shrink{.shrink = {}, .generations = 3});
        appendWhole(grown.steps, everywhere(size, false, stays, all));
        grown.steps.push_back(Undo{});
        appendWhole(grown.steps, everywhere(size, true, {}, all));
        appendBurst(grown.steps, taking({1, 2, 3, 4}, 26), 4);
        cases.push_back(grown);
    }

    EngineCase refused{"shutting that is refused", codes, {}};
    Places whole;
    whole.set();
    appendWhole(refused.steps, BarrierListed{.bricks = {{12, whole}}}); // there are 12
    appendWhole(refused.steps, BarrierListed{.bricks = {{3, whole}, {2, whole}}});
    appendWhole(refused.steps, BarrierListed{.bricks = {{3, whole}, {3, whole}}});
    cases.push_back(refused);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomBarriers(number));
    return cases;
}

} // namespace test
