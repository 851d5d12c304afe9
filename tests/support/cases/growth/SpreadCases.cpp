// SPDX-License-Identifier: Apache-2.0

#include "core/growth/SeedWord.h"
#include "tests/support/cases/EngineCases.h"

#include <algorithm>
#include <array>

namespace test {

namespace {

using core::SeedPlacement;
using core::SpreadLabels;

Bytes noLabels(const glm::ivec3& size)
{
    return {size, std::vector<std::uint8_t>(std::size_t(size.x) * size.y * size.z, 0)};
}

EngineStep painted(const Bytes& labels)
{
    return command(core::SwapBricks{bricksOf(labels, core::Field::Labels, 0)});
}

/// Barriers wherever a voxel is chosen; all else that was sketched there goes.
EngineStep barred(const glm::ivec3& size, const std::vector<glm::ivec3>& voxels)
{
    const core::BrickGrid grid{size};
    core::SwapBricks swap;
    for (int brick = 0; brick < grid.brickCount(); ++brick)
        swap.bricks.push_back({{core::Field::SeedWords, 0, std::uint32_t(brick)},
            std::vector<std::uint8_t>(std::size_t(4) * core::BrickGrid::voxelsPerBrick, 0xFF)});
    for (const glm::ivec3& voxel : voxels) {
        auto& bytes = swap.bricks[std::size_t(grid.brickOf(voxel))].bytes.write();
        std::fill_n(bytes.begin() + 4 * std::ptrdiff_t(core::BrickGrid::offsetInBrick(voxel)), 4,
            std::uint8_t(core::seedWord::barrier));
    }
    return command(std::move(swap));
}

SpreadLabels between(std::initializer_list<int> labels)
{
    SpreadLabels spread;
    spread.lengths = {4, 4, 4, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7};
    for (const int label : labels)
        spread.seeds.set(std::size_t(label));
    return spread;
}

/// As a window shows it: worked out, then decided on.
void appendPreview(std::vector<EngineStep>& steps, const SpreadLabels& spread, core::Ending ending,
    bool finished = true)
{
    steps.push_back(command(core::BeginEdit{spread}));
    if (finished) {
        steps.push_back(Settle{});
        steps.push_back(command(core::ProbeVoxels{{{0, 0, 0}}, spread.plane})); // it shows
    }
    steps.push_back(command(core::EndEdit{ending}));
}

void paintBox(Bytes& labels, std::uint8_t label, Random& random, int reach)
{
    const glm::ivec3 from = randomVoxel(random, labels.size);
    for (int z = from.z; z < std::min(from.z + reach, labels.size.z); ++z)
        for (int y = from.y; y < std::min(from.y + reach, labels.size.y); ++y)
            for (int x = from.x; x < std::min(from.x + reach, labels.size.x); ++x)
                labels.at({x, y, z}) = label;
}

Codes randomSpreadCodes(const glm::ivec3& size, Random& random)
{
    switch (random() % 5) {
    case 0:
        return constantVolume(size, tissueCode);
    case 1:
        return noiseVolume(size, random() % 2 ? 30 : 65535, random);
    case 2:
        return shells(size);
    default:
        return balls(size, randomInt(random, 2, 8), random);
    }
}

SpreadLabels randomSpread(const glm::ivec3& size, Random& random)
{
    SpreadLabels spread = between({1, 2});
    for (const int label : {3, 254, 255}) {
        if (random() % 2)
            spread.seeds.set(std::size_t(label));
        else if (random() % 2)
            spread.overwritable.set(std::size_t(label));
    }
    spread.connectivity = std::array<int, 4>{6, 6, 18, 26}[random() % 4];
    spread.differenceWeight = std::array<std::uint32_t, 4>{0, 1, 4, 64}[random() % 4];
    for (std::uint32_t& length : spread.lengths)
        length = std::uint32_t(random() % 4 ? randomInt(random, 1, 9) : 1);
    if (random() % 8 == 0)
        spread.lengths[1] = 65535;
    if (random() % 3 == 0) {
        const glm::ivec3 a = randomVoxel(random, size);
        const glm::ivec3 b = randomVoxel(random, size);
        spread.box = core::VoxelBox{glm::min(a, b), glm::max(a, b) + 1};
    }
    return spread;
}

/// Previews between which seeds come, go and change hands, walls too: what an engine keeps from one
/// to the next must not show.
EngineCase randomSpreading(int number)
{
    Random random(std::uint32_t(26000 + number));
    const bool small = random() % 4 == 0;
    const glm::ivec3 size{randomInt(random, 1, small ? 6 : 48), randomInt(random, 2, 40),
        randomInt(random, 1, small ? 40 : 36)};
    EngineCase made{"random growing from seeds " + QByteArray::number(number),
        randomSpreadCodes(size, random), {}};
    const std::array<std::uint8_t, 6> some{1, 2, 3, 254, 255, 0};
    Bytes labels = noLabels(size);
    SpreadLabels spread = randomSpread(size, random);
    Random ranges(std::uint32_t(45000 + number));
    for (int round = randomInt(random, 2, 7); round > 0; --round) {
        for (int i = randomInt(random, 0, 4); i > 0; --i)
            paintBox(labels, some[random() % some.size()], random, randomInt(random, 1, 5));
        if (random() % 5)
            made.steps.push_back(painted(labels));
        if (random() % 3 == 0) {
            SeedPlacement seeds{.label = some[random() % 5]};
            appendSeeds(made.steps, seeds, randomInt(random, 1, 4), size, random);
        }
        if (random() % 6 == 0) {
            std::vector<glm::ivec3> wall;
            for (int i = randomInt(random, 0, 60); i > 0; --i)
                wall.push_back(randomVoxel(random, size));
            made.steps.push_back(barred(size, wall));
        }
        if (random() % 4 == 0)
            spread = randomSpread(size, random);
        if (random() % 5 == 0)
            spread.box.reset();
        if (number % 2) {
            spread.range = randomGrowthRange(tissueCode, ranges).value_or(core::GrowthRange());
            spread.within.reset();
            if (ranges() % 3 == 0) {
                const glm::ivec3 a = randomVoxel(ranges, size);
                const glm::ivec3 b = randomVoxel(ranges, size);
                spread.within = core::VoxelBox{glm::min(a, b), glm::max(a, b) + 1};
            }
        }
        const bool commit = random() % 4 == 0;
        appendPreview(made.steps, spread, commit ? core::Ending::Commit : core::Ending::Rollback,
            random() % 5);
        if (commit && random() % 2)
            made.steps.push_back(Undo{});
        if (commit && random() % 3 == 0)
            made.steps.push_back(Redo{});
    }
    appendPreview(made.steps, spread, core::Ending::Commit);
    return made;
}

} // namespace

std::vector<EngineCase> spreadCases(int randomCount)
{
    std::vector<EngineCase> cases;
    Random random(26);
    const glm::ivec3 size(40, 33, 21);

    EngineCase halves{
        "seeds at both ends of what is all alike", constantVolume({49, 17, 5}, 9), {}};
    Bytes ends = noLabels({49, 17, 5});
    ends.at({0, 8, 2}) = 7;
    ends.at({48, 8, 2}) = 3;
    halves.steps.push_back(painted(ends));
    appendPreview(halves.steps, between({3, 7}), core::Ending::Commit);
    halves.steps.push_back(Undo{});
    halves.steps.push_back(Redo{});
    cases.push_back(halves);

    for (const int connectivity : {6, 18, 26}) {
        EngineCase made{"growing from seeds, " + QByteArray::number(connectivity) + " neighbours",
            balls(size, 6, random), {}};
        Bytes labels = noLabels(size);
        for (int i = 0; i < 6; ++i)
            paintBox(labels, std::uint8_t(i % 3 + 1), random, 4);
        made.steps.push_back(painted(labels));
        appendWhole(made.steps, SeedPlacement{.label = 2, .voxels = {{0, 0, 0}, {39, 32, 20}}});
        SpreadLabels spread = between({1, 2, 3});
        spread.connectivity = connectivity;
        appendPreview(made.steps, spread, core::Ending::Rollback);
        for (int i = 0; i < 3; ++i) {
            paintBox(labels, std::uint8_t(i), random, 6); // the first one erases
            made.steps.push_back(painted(labels));
            appendPreview(made.steps, spread, core::Ending::Rollback);
        }
        made.steps.push_back(command(core::BeginEdit{spread}));
        made.steps.push_back(command(core::ExtendEdit{core::ForgetSpread{}}));
        made.steps.push_back(command(core::EndEdit{core::Ending::Rollback}));
        appendPreview(made.steps, spread, core::Ending::Commit);
        cases.push_back(made);
    }

    EngineCase shut{"growing from seeds behind walls", noiseVolume(size, 20, random), {}};
    Bytes walls = noLabels(size);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            walls.at({20, y, z}) = 9; // of another segment, from side to side
    walls.at({1, 1, 1}) = 1;
    walls.at({38, 30, 19}) = 2;
    walls.at({30, 3, 3}) = 5; // neither competes nor may be taken
    shut.steps.push_back(painted(walls));
    appendPreview(shut.steps, between({1, 2}), core::Ending::Rollback);
    SpreadLabels over = between({1, 2});
    over.overwritable.set(9);
    appendPreview(shut.steps, over, core::Ending::Rollback);
    appendPreview(shut.steps, between({1, 2}), core::Ending::Commit);
    cases.push_back(shut);

    // Hundreds of rounds to rest in one brick, when a seed comes and when it goes.
    const glm::ivec3 zigzagSize(32, 14, 15);
    for (const int connectivity : {18, 26}) {
        EngineCase zigzag{"growing from seeds along a zigzag, " + QByteArray::number(connectivity)
                + " neighbours",
            zigzagCorridor(zigzagSize), {}};
        Bytes sides = noLabels(zigzagSize);
        for (std::size_t i = 0; i < sides.values.size(); ++i)
            sides.values[i] = zigzag.codes.values[i] == tissueCode ? 0 : 9;
        SpreadLabels along = between({1, 2});
        along.connectivity = connectivity;
        along.box = core::VoxelBox{glm::ivec3(0), zigzagSize};
        sides.at({0, 0, 0}) = 1;
        sides.at({1, 1, 0}) = 2;
        zigzag.steps.push_back(painted(sides));
        appendPreview(zigzag.steps, along, core::Ending::Rollback);
        sides.at({1, 1, 0}) = 0;
        sides.at({0, 0, 14}) = 2;
        zigzag.steps.push_back(painted(sides));
        appendPreview(zigzag.steps, along, core::Ending::Commit);
        cases.push_back(zigzag);
    }

    EngineCase far{"paths that would cost too much", checkerboard({70, 5, 5}), {}};
    for (std::uint16_t& code : far.codes.values)
        code = code == tissueCode ? 65535 : 0;
    Bytes one = noLabels({70, 5, 5});
    one.at({0, 2, 2}) = 1;
    one.at({1, 2, 2}) = 2;
    far.steps.push_back(painted(one));
    SpreadLabels dear = between({1, 2});
    dear.differenceWeight = 64;
    dear.box = core::VoxelBox{glm::ivec3(0), {70, 5, 5}};
    appendPreview(far.steps, dear, core::Ending::Commit);
    cases.push_back(far);

    EngineCase refused{"growing from seeds that is refused", constantVolume({20, 20, 20}, 4), {}};
    appendWhole(refused.steps, between({1, 2})); // nothing there
    appendWhole(refused.steps, SeedPlacement{.label = 1, .voxels = {{3, 3, 3}}});
    appendWhole(refused.steps, between({1, 2})); // one alone
    appendWhole(refused.steps, SeedPlacement{.label = 2, .voxels = {{13, 3, 3}}});
    SpreadLabels wrong = between({1, 2});
    wrong.lengths[2] = 0;
    appendWhole(refused.steps, wrong);
    wrong = between({0, 1, 2});
    appendWhole(refused.steps, wrong);
    wrong = between({1, 2});
    wrong.overwritable.set(2);
    appendWhole(refused.steps, wrong);
    wrong = between({1, 2});
    wrong.box = core::VoxelBox{{0, 0, 0}, {21, 20, 20}};
    appendWhole(refused.steps, wrong);
    wrong = between({1, 2});
    wrong.connectivity = 8;
    appendWhole(refused.steps, wrong);
    refused.steps.push_back(command(core::BeginEdit{between({1, 2})}));
    refused.steps.push_back(command(core::ExtendEdit{core::GrowAdvance{}}));
    refused.steps.push_back(command(core::EndEdit{}));
    refused.steps.push_back(command(core::BeginEdit{SeedPlacement{.label = 1}}));
    refused.steps.push_back(command(core::ExtendEdit{core::ForgetSpread{}}));
    refused.steps.push_back(command(core::EndEdit{}));
    cases.push_back(refused);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomSpreading(number));
    return cases;
}

} // namespace test
