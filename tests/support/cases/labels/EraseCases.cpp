// SPDX-License-Identifier: Apache-2.0

#include "tests/support/cases/EngineCases.h"
#include <array>

namespace test {

namespace {

using core::EraseLabel;
using core::GrowAdvance;
using core::GrowBurst;
using core::SeedPlacement;

const GrowBurst wholeRange{.lowCode = 0, .highCode = 65535};

Bytes noLabels(const glm::ivec3& size)
{
    return {size, std::vector<std::uint8_t>(std::size_t(size.x) * size.y * size.z, 0)};
}

void paintCorners(Bytes& labels, std::uint8_t label)
{
    for (int corner = 0; corner < 8; ++corner)
        labels.at({corner & 1 ? labels.size.x - 1 : 0, corner & 2 ? labels.size.y - 1 : 0,
            corner & 4 ? labels.size.z - 1 : 0}) = label;
}

EngineStep painted(const Bytes& labels, std::uint8_t plane)
{
    return command(core::SwapBricks{bricksOf(labels, core::Field::Labels, plane)});
}

EngineCase randomErasing(int number)
{
    Random random(std::uint32_t(12000 + number));
    const glm::ivec3 size{
        randomInt(random, 1, 40), randomInt(random, 1, 40), randomInt(random, 1, 40)};
    EngineCase made{
        "random erasing " + QByteArray::number(number), noiseVolume(size, tissueCode, random), {}};
    const std::array<std::uint8_t, 4> labels{1, 2, 254, 255};
    const auto label = [&] { return labels[random() % labels.size()]; };
    if (random() % 2) {
        Bytes bytes = noLabels(size);
        const bool sparse = random() % 2;
        for (std::uint8_t& value : bytes.values)
            value = sparse && random() % 50 ? std::uint8_t(0) : label();
        made.steps.push_back(painted(bytes, 0));
    }
    for (int edit = randomInt(random, 4, 12); edit > 0; --edit) {
        const auto plane = std::uint8_t(random() % 6 ? 0 : 1);
        switch (random() % 8) {
        case 0:
        case 1: {
            SeedPlacement seeds{.plane = plane, .label = label()};
            appendSeeds(made.steps, seeds, randomInt(random, 0, 4), size, random);
            break;
        }
        case 2:
        case 3: {
            GrowBurst burst = wholeRange;
            burst.plane = plane;
            burst.highCode = randomInt(random, 0, tissueCode);
            burst.overwritable[label()] = random() % 2;
            appendBurst(
                made.steps, burst, random() % 3 ? randomInt(random, 0, 4) : GrowAdvance::toClosure);
            break;
        }
        case 4:
            made.steps.push_back(Undo{});
            break;
        case 5:
            made.steps.push_back(Redo{});
            break;
        default:
            appendWhole(made.steps, EraseLabel{.plane = plane, .label = label()}, {},
                random() % 5 ? core::Ending::Commit : core::Ending::Rollback);
            break;
        }
    }
    return made;
}

} // namespace

std::vector<EngineCase> eraseCases(int randomCount)
{
    std::vector<EngineCase> cases;
    const glm::ivec3 size(33, 18, 20); // no multiple of a brick along any axis
    const Codes codes = constantVolume(size, tissueCode);

    EngineCase nothing{"erase what is not there", codes, {}};
    appendWhole(nothing.steps, EraseLabel{.label = 255}); // unvisited words have its bits
    appendWhole(nothing.steps, EraseLabel{.label = 7});
    Bytes corners = noLabels(size);
    paintCorners(corners, 5);
    nothing.steps.push_back(painted(corners, 0));
    appendWhole(nothing.steps, EraseLabel{.label = 7});
    appendWhole(nothing.steps, EraseLabel{.plane = 1, .label = 5});
    cases.push_back(nothing);

    EngineCase borders{"erase at the volume's corners", codes, {}};
    corners.at(size / 2) = 6;
    corners.at({0, 1, 0}) = 6; // in a brick that holds both
    borders.steps.push_back(painted(corners, 0));
    borders.steps.push_back(painted(corners, 1));
    appendWhole(borders.steps, EraseLabel{.label = 5});
    borders.steps.push_back(command(core::ProbeVoxels{{{0, 0, 0}, {0, 1, 0}, size - 1}}));
    borders.steps.push_back(Undo{});
    borders.steps.push_back(Redo{});
    appendWhole(borders.steps, EraseLabel{.label = 6});
    appendWhole(borders.steps, EraseLabel{.plane = 1, .label = 6}, {}, core::Ending::Rollback);
    cases.push_back(borders);

    EngineCase pending{"erase pending seeds", codes, {}};
    appendWhole(pending.steps, SeedPlacement{.label = 255, .voxels = {{0, 0, 0}, {32, 17, 19}}});
    appendWhole(pending.steps, SeedPlacement{.label = 3, .voxels = {{1, 0, 0}, {16, 16, 16}}});
    appendWhole(pending.steps, EraseLabel{.label = 255});
    appendBurst(pending.steps, wholeRange, 3);
    pending.steps.push_back(Undo{});
    pending.steps.push_back(Undo{});
    appendBurst(pending.steps, wholeRange, 3);
    cases.push_back(pending);

    EngineCase grown{"erase what has grown beside another", codes, {}};
    appendWhole(grown.steps, SeedPlacement{.label = 1, .voxels = {{0, 0, 0}}});
    appendWhole(grown.steps, SeedPlacement{.label = 2, .voxels = {{32, 17, 19}}});
    appendBurst(grown.steps, wholeRange, GrowAdvance::toClosure);
    appendWhole(grown.steps, EraseLabel{.label = 1});
    // The other one goes on into what became free; the one erased does not.
    appendBurst(grown.steps, wholeRange, 4);
    appendBurst(grown.steps, wholeRange, GrowAdvance::toClosure);
    for (int i = 0; i < 3; ++i)
        grown.steps.push_back(Undo{});
    for (int i = 0; i < 2; ++i)
        grown.steps.push_back(Redo{});
    appendWhole(grown.steps, EraseLabel{.label = 2});
    appendBurst(grown.steps, wholeRange, GrowAdvance::toClosure); // from nothing
    cases.push_back(grown);

    EngineCase refused{"erase that is refused", codes, {}};
    refused.steps.push_back(painted(corners, 0));
    appendWhole(refused.steps, EraseLabel{.label = 0});
    refused.steps.push_back(command(core::BeginEdit{EraseLabel{.label = 5}}));
    refused.steps.push_back(command(core::BeginEdit{EraseLabel{.label = 6}}));
    refused.steps.push_back(command(core::ExtendEdit{GrowAdvance{}}));
    refused.steps.push_back(command(core::ExtendEdit{core::DrillPath{}}));
    refused.steps.push_back(command(core::EndEdit{}));
    cases.push_back(refused);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomErasing(number));
    return cases;
}

} // namespace test
