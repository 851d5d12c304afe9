// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/EngineCases.h"

#include <array>

namespace test {

namespace {

using core::LabelThreshold;
using How = core::LabelThreshold::How;

constexpr int highestBlock = 900; ///< code

/// Blocks of a brick's size and of half of it, each of one code, with specks of others: bricks
/// that lie wholly inside an interval, wholly outside, and neither.
Codes blocks(const glm::ivec3& size, Random& random)
{
    const int side = random() % 2 ? 16 : 8;
    const glm::ivec3 count = size / side + 1;
    std::vector<int> codes;
    for (int i = count.x * count.y * count.z; i > 0; --i)
        codes.push_back(randomInt(random, 0, 9) * 100);
    const unsigned specks = random() % 3 ? 700 : 0; // one among so many
    Codes made{size, {}};
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const int block = ((z / side) * count.y + y / side) * count.x + x / side;
                const bool speck = specks != 0 && random() % specks == 0;
                made.values.push_back(
                    std::uint16_t(speck ? randomInt(random, 0, 65535) : codes[std::size_t(block)]));
            }
        }
    }
    return made;
}

Bytes randomCoverage(const glm::ivec3& size, Random& random)
{
    Bytes bytes{size, {}};
    constexpr std::array<std::uint8_t, 6> known{0, 0, 1, 127, 128, 255};
    for (int i = size.x * size.y * size.z; i > 0; --i)
        bytes.values.push_back(known[random() % known.size()]);
    return bytes;
}

core::VoxelBox boxBetweenVoxels(const glm::ivec3& size, Random& random)
{
    const glm::ivec3 one = randomVoxel(random, size);
    const glm::ivec3 other = randomVoxel(random, size);
    core::VoxelBox box{glm::min(one, other), glm::max(one, other) + 1};
    if (random() % 8 == 0)
        box.minimum -= 1000; // beyond the volume
    if (random() % 8 == 0)
        box.maximum += 1000;
    return box;
}

LabelThreshold randomThreshold(const glm::ivec3& size, std::uint8_t plane, Random& random)
{
    LabelThreshold edit{.target = {.plane = plane, .label = std::uint8_t(randomInt(random, 1, 4))},
        .how = How(random() % 3)};
    for (std::size_t label = 1; label < 6; ++label)
        edit.target.overwritable[label] = random() % 3 == 0;
    // Often at the very code of a block.
    if (random() % 4)
        edit.lowCode =
            random() % 2 ? randomInt(random, 0, 9) * 100 : randomInt(random, -5, highestBlock);
    if (random() % 4)
        edit.highCode =
            random() % 2 ? randomInt(random, 0, 9) * 100 : randomInt(random, -5, highestBlock);
    edit.onlyVisible = random() % 3 == 0;
    if (random() % 3 == 0)
        edit.box = boxBetweenVoxels(size, random);
    return edit;
}

EngineCase randomThresholds(int number)
{
    Random random(std::uint32_t(93000 + number));
    const int x = randomInt(random, 1, 50);
    const int y = randomInt(random, 1, 40);
    const int z = randomInt(random, 1, 40);
    const glm::ivec3 size(x, y, z);
    EngineCase made{"random thresholds " + QByteArray::number(number),
        random() % 4 ? blocks(size, random) : noiseVolume(size, highestBlock, random), {}};
    made.steps.push_back(command(
        core::SwapBricks{bricksOf(randomCoverage(size, random), core::Field::Coverage, 1)}));
    if (random() % 3)
        made.steps.push_back(command(
            core::SwapBricks{bricksOf(labelBoxes(size, 6, random), core::Field::Labels, 0)}));
    for (int edit = randomInt(random, 4, 12); edit > 0; --edit) {
        const auto plane = std::uint8_t(random() % 6 ? 0 : 1);
        const int what = int(random() % 8);
        if (appendBetween(made.steps, what, plane, size, random))
            continue;
        if (what == 3) {
            core::MuteLayers mute;
            mute.muted[1] = random() % 2;
            made.steps.push_back(command(mute));
        } else {
            appendWhole(made.steps, randomThreshold(size, plane, random), {},
                random() % 5 ? core::Ending::Commit : core::Ending::Rollback);
        }
    }
    return made;
}

} // namespace

std::vector<EngineCase> thresholdCases(int randomCount)
{
    std::vector<EngineCase> cases;
    const glm::ivec3 size(33, 18, 20); // no multiple of a brick along any axis
    Random random(19);
    const core::LabelTarget first{.plane = 0, .label = 1};
    const core::LabelTarget second{.plane = 0, .label = 2};

    EngineCase ends{"thresholds that end at a code", noiseVolume(size, 9, random), {}};
    appendWhole(ends.steps, LabelThreshold{.target = first, .lowCode = 3, .highCode = 3});
    appendWhole(ends.steps, LabelThreshold{.target = first, .lowCode = 4, .highCode = 5});
    appendWhole(
        ends.steps, LabelThreshold{.target = second, .how = How::Add, .lowCode = 5, .highCode = 7});
    core::LabelTarget taker = second;
    taker.overwritable.set(1);
    appendWhole(
        ends.steps, LabelThreshold{.target = taker, .how = How::Add, .lowCode = 5, .highCode = 7});
    appendWhole(ends.steps, LabelThreshold{.target = second, .how = How::Subtract, .lowCode = 7});
    appendWhole(ends.steps, LabelThreshold{.target = second, .lowCode = 8, .highCode = 2});
    appendWhole(ends.steps, LabelThreshold{.target = first, .lowCode = 65536});
    appendWhole(
        ends.steps, LabelThreshold{.target = first, .highCode = -1}, {}, core::Ending::Rollback);
    for (int i = 0; i < 5; ++i)
        ends.steps.push_back(Undo{});
    ends.steps.push_back(Redo{});
    cases.push_back(ends);

    // One voxel beside a brick is the only one of its value: no neighbour tells of it.
    EngineCase lone{"a lone voxel at the corner of a brick", constantVolume(size, 500), {}};
    lone.codes.values[std::size_t((16 * size.y + 16) * size.x + 16)] = 501;
    appendWhole(lone.steps, LabelThreshold{.target = first, .lowCode = 501});
    appendWhole(lone.steps, LabelThreshold{.target = second, .highCode = 500});
    appendWhole(lone.steps, LabelThreshold{.target = first, .how = How::Subtract, .lowCode = 501});
    appendWhole(lone.steps, LabelThreshold{.target = second, .lowCode = 501, .highCode = 501});
    lone.steps.push_back(Undo{});
    cases.push_back(lone);

    EngineCase grown{"thresholds among members and seeds", noiseVolume(size, 99, random), {}};
    appendWhole(grown.steps, core::SeedPlacement{.label = 1, .voxels = {{0, 0, 0}, size / 2}});
    appendWhole(grown.steps, core::SeedPlacement{.label = 2, .voxels = {{1, 0, 0}, size - 1}});
    appendBurst(grown.steps, {.lowCode = 0, .highCode = 65535}, 6);
    appendWhole(grown.steps, core::SeedPlacement{.label = 3, .voxels = {{32, 0, 0}}});
    appendWhole(grown.steps, LabelThreshold{.target = taker, .lowCode = 30, .highCode = 80});
    appendBurst(grown.steps, {.lowCode = 0, .highCode = 65535}, 3);
    appendWhole(grown.steps, LabelThreshold{.target = first, .how = How::Subtract, .highCode = 50});
    // A seed that waits goes, too, where no label is held.
    appendWhole(
        grown.steps, LabelThreshold{.target = {.plane = 0, .label = 3}, .how = How::Subtract});
    appendBurst(grown.steps, {.lowCode = 0, .highCode = 65535}, 3);
    for (int i = 0; i < 4; ++i)
        grown.steps.push_back(Undo{});
    cases.push_back(grown);

    EngineCase ranges{
        "thresholds in a box and where nothing is carved", noiseVolume(size, 99, random), {}};
    ranges.steps.push_back(command(
        core::SwapBricks{bricksOf(randomCoverage(size, random), core::Field::Coverage, 1)}));
    appendWhole(ranges.steps, LabelThreshold{.target = first, .lowCode = 20, .onlyVisible = true});
    core::MuteLayers mute;
    mute.muted.set(1);
    ranges.steps.push_back(command(mute));
    appendWhole(ranges.steps, LabelThreshold{.target = second, .lowCode = 50, .onlyVisible = true});
    appendWhole(ranges.steps,
        LabelThreshold{
            .target = first, .lowCode = 90, .box = core::VoxelBox{{15, 0, 3}, {17, 9, 19}}});
    appendWhole(ranges.steps,
        LabelThreshold{.target = second,
            .how = How::Subtract,
            .box = core::VoxelBox{{-9, -9, -9}, {1, 99, 99}}});
    appendWhole(ranges.steps,
        LabelThreshold{.target = first, .box = core::VoxelBox{{40, 0, 0}, {50, 9, 9}}});
    appendWhole(ranges.steps, LabelThreshold{.target = first, .box = core::VoxelBox{}});
    cases.push_back(ranges);

    EngineCase refused{"a threshold for no label", noiseVolume(size, 9, random), {}};
    appendWhole(refused.steps, LabelThreshold{});
    refused.steps.push_back(command(core::BeginEdit{LabelThreshold{.target = first}}));
    refused.steps.push_back(command(core::ExtendEdit{core::DrillPath{}}));
    refused.steps.push_back(command(core::ExtendEdit{core::GrowAdvance{}}));
    refused.steps.push_back(command(core::EndEdit{}));
    cases.push_back(refused);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomThresholds(number));
    return cases;
}

} // namespace test
