// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/EngineCases.h"

namespace test {

namespace {

using core::LabelTarget;
using core::RelabelListed;

constexpr std::uint8_t give = RelabelListed::give;
constexpr std::uint8_t take = RelabelListed::take;

/// Every voxel of every brick by a rule, those beyond the volume's rim too.
template <class Rule>
RelabelListed everywhere(const glm::ivec3& size, const LabelTarget& target, Rule rule)
{
    RelabelListed edit{.target = target};
    for (int brick = 0; brick < core::BrickGrid{size}.brickCount(); ++brick) {
        std::vector<std::uint8_t> asked;
        for (int voxel = 0; voxel < core::BrickGrid::voxelsPerBrick; ++voxel)
            asked.push_back(rule(voxel));
        edit.bricks.push_back({.brick = std::uint32_t(brick), .asked = std::move(asked)});
    }
    return edit;
}

LabelTarget targetOf(std::uint8_t label, std::initializer_list<std::size_t> overwritable = {})
{
    LabelTarget target{.plane = 0, .label = label};
    for (const std::size_t each : overwritable)
        target.overwritable.set(each);
    return target;
}

void appendGrowth(std::vector<EngineStep>& steps, int count)
{
    steps.push_back(BeginGrowth{{.lowCode = 0, .highCode = 65535}});
    steps.push_back(command(core::ExtendEdit{core::GrowAdvance{count}}));
    steps.push_back(command(core::EndEdit{}));
}

/// Two segments that grow, a third that waits, and a seed in what another one has grown over.
void appendRelabelled(std::vector<EngineStep>& steps, const glm::ivec3& size)
{
    appendWhole(steps, core::SeedPlacement{.label = 1, .voxels = {{0, 0, 0}, size / 2}});
    appendWhole(steps, core::SeedPlacement{.label = 2, .voxels = {{1, 0, 0}, size - 1}});
    appendGrowth(steps, 4);
    appendWhole(steps, core::SeedPlacement{.label = 1, .voxels = {{0, size.y - 1, 0}}});
    appendWhole(steps, core::SeedPlacement{.label = 3, .voxels = {{size.x - 1, 0, 0}}});
}

RelabelListed randomRelabelList(const glm::ivec3& size, std::uint8_t plane, Random& random)
{
    RelabelListed edit{.target = {.plane = plane, .label = std::uint8_t(randomInt(random, 1, 4))}};
    for (std::size_t label = 1; label < 6; ++label)
        edit.target.overwritable[label] = random() % 3 == 0;
    const unsigned sparse = random() % 2 ? 2 : 40;
    for (int brick = 0; brick < core::BrickGrid{size}.brickCount(); ++brick) {
        if (random() % 3 == 0)
            continue;
        std::vector<std::uint8_t> asked(core::BrickGrid::voxelsPerBrick);
        for (std::uint8_t& each : asked)
            each = random() % sparse ? 0 : random() % 2 ? give : take;
        edit.bricks.push_back({.brick = std::uint32_t(brick), .asked = std::move(asked)});
    }
    return edit;
}

core::ReadCodes randomBox(const glm::ivec3& size, Random& random)
{
    const glm::ivec3 one = randomVoxel(random, size);
    const glm::ivec3 other = randomVoxel(random, size);
    return {.box = {glm::min(one, other), glm::max(one, other) + 1}};
}

EngineCase randomRelabelling(int number)
{
    Random random(std::uint32_t(64000 + number));
    const glm::ivec3 size{
        randomInt(random, 1, 40), randomInt(random, 1, 40), randomInt(random, 1, 40)};
    EngineCase made{"random relabelling " + QByteArray::number(number),
        noiseVolume(size, tissueCode, random), {}};
    if (random() % 3)
        made.steps.push_back(command(
            core::SwapBricks{bricksOf(labelBoxes(size, 6, random), core::Field::Labels, 0)}));
    for (int edit = randomInt(random, 4, 12); edit > 0; --edit) {
        const auto plane = std::uint8_t(random() % 6 ? 0 : 1);
        const int what = int(random() % 6);
        if (what == 1) {
            made.steps.push_back(BeginGrowth{{.plane = plane, .lowCode = 0, .highCode = 65535}});
            made.steps.push_back(command(core::ExtendEdit{core::GrowAdvance{3}}));
            made.steps.push_back(command(randomBox(size, random))); // while it is open
            made.steps.push_back(command(core::EndEdit{}));
        } else if (!appendBetween(made.steps, what, plane, size, random)) {
            appendWhole(made.steps, randomRelabelList(size, plane, random), {},
                random() % 5 ? core::Ending::Commit : core::Ending::Rollback);
        }
    }
    made.steps.push_back(command(randomBox(size, random)));
    return made;
}

} // namespace

std::vector<EngineCase> relabelCases(int randomCount)
{
    std::vector<EngineCase> cases;
    const glm::ivec3 size(33, 18, 20); // no multiple of a brick along any axis
    Random random(7);
    const Codes codes = noiseVolume(size, 65535, random);
    const auto all = [](std::uint8_t asked) { return [asked](int) { return asked; }; };
    const auto byTurns = [](int voxel) { return voxel % 2 ? give : take; };

    EngineCase nothing{"nothing is relabelled", codes, {}};
    appendWhole(nothing.steps, RelabelListed{.target = targetOf(1)});
    appendWhole(nothing.steps, everywhere(size, targetOf(1), all(0)));
    appendWhole(nothing.steps, everywhere(size, targetOf(1), all(take)));
    cases.push_back(nothing);

    EngineCase rim{"relabelled up to the rim", codes, {}};
    appendWhole(rim.steps, everywhere(size, targetOf(1), all(give)));
    appendWhole(rim.steps, everywhere(size, targetOf(1), all(give))); // nothing is left to do
    appendWhole(rim.steps, everywhere(size, targetOf(1), byTurns));
    appendWhole(rim.steps, everywhere(size, targetOf(255), all(give))); // only what is free
    appendWhole(
        rim.steps, everywhere(size, targetOf(255, {1}), all(give)), {}, core::Ending::Rollback);
    appendWhole(rim.steps, everywhere(size, targetOf(255), all(take)));
    for (int i = 0; i < 3; ++i)
        rim.steps.push_back(Undo{});
    rim.steps.push_back(Redo{});
    cases.push_back(rim);

    for (const std::uint8_t label : {1, 2, 3}) {
        EngineCase grown{
            "relabelled among members and seeds of " + QByteArray::number(label), codes, {}};
        appendRelabelled(grown.steps, size);
        appendWhole(grown.steps, everywhere(size, targetOf(label), byTurns));
        grown.steps.push_back(Undo{});
        appendWhole(grown.steps, everywhere(size, targetOf(label, {1, 2}), byTurns));
        grown.steps.push_back(Undo{});
        appendWhole(grown.steps, everywhere(size, targetOf(label), all(take)));
        appendWhole(grown.steps, everywhere(size, targetOf(label, {2}), all(give)));
        appendGrowth(grown.steps, 3); // only what is left of members goes on
        grown.steps.push_back(Undo{});
        cases.push_back(grown);
    }

    EngineCase boxes{"codes of boxes", codes, {}};
    for (const core::VoxelBox& box :
        {core::VoxelBox{{0, 0, 0}, size}, {size - 1, size}, {{15, 15, 15}, {18, 18, 17}},
            {{5, 5, 5}, {5, 6, 6}}, {{-1, 0, 0}, {2, 2, 2}}, {{0, 0, 0}, size + 1}})
        boxes.steps.push_back(command(core::ReadCodes{box}));
    cases.push_back(boxes);

    EngineCase refused{"relabelling that is refused", codes, {}};
    const std::vector<std::uint8_t> whole(core::BrickGrid::voxelsPerBrick, give);
    std::vector<std::uint8_t> unknown = whole;
    unknown.back() = 3;
    appendWhole(refused.steps, RelabelListed{.bricks = {{3, whole}}}); // no label
    appendWhole(refused.steps, RelabelListed{.target = targetOf(1), .bricks = {{12, whole}}});
    appendWhole(
        refused.steps, RelabelListed{.target = targetOf(1), .bricks = {{3, whole}, {2, whole}}});
    appendWhole(refused.steps, RelabelListed{.target = targetOf(1), .bricks = {{3, {give}}}});
    appendWhole(refused.steps, RelabelListed{.target = targetOf(1), .bricks = {{3, unknown}}});
    cases.push_back(refused);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomRelabelling(number));
    return cases;
}

} // namespace test
