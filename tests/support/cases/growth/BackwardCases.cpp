// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/growth/BackwardScenes.h"

#include <array>
#include <utility>

namespace test {

namespace {

using core::CutGrowth;
using core::GrowAdvance;
using core::GrowBurst;

Cut backwards(const std::vector<glm::ivec3>& sketch, std::uint32_t steps,
    std::vector<std::uint32_t> then = {}, core::Ending ending = core::Ending::Commit)
{
    return {.cut = {.how = CutGrowth::How::Backwards, .voxels = sketch, .steps = steps},
        .then = std::move(then),
        .ending = ending};
}

EngineCase grown(const BackwardScene& scene, int connectivity)
{
    EngineCase made{
        "backwards, " + scene.name + ", " + QByteArray::number(connectivity) + " neighbours",
        scene.codes, {}};
    appendWhole(made.steps, core::SeedPlacement{.label = 1, .voxels = scene.seeds});
    if (!scene.others.empty())
        appendWhole(made.steps, core::SeedPlacement{.label = 2, .voxels = scene.others});
    made.steps.emplace_back(BeginGrowth{
        GrowBurst{.lowCode = tissueCode, .highCode = tissueCode, .connectivity = connectivity}});
    made.steps.emplace_back(core::EngineCommand(core::ExtendEdit{GrowAdvance{}}));
    made.steps.emplace_back(core::EngineCommand(core::EndEdit{}));
    return made;
}

/// Growths of up to two labels in bursts that differ, over labels that were there, with sketches
/// anywhere in what can grow.
EngineCase randomBackwards(int number)
{
    Random random(std::uint32_t(41000 + number));
    const glm::ivec3 size{
        randomInt(random, 4, 24), randomInt(random, 4, 24), randomInt(random, 3, 18)};
    EngineCase made{"backwards at random " + QByteArray::number(number),
        random() % 2 ? balls(size, 6, random) : constantVolume(size, tissueCode), {}};
    std::vector<glm::ivec3> tissue;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                if (made.codes.at({x, y, z}) == tissueCode)
                    tissue.emplace_back(x, y, z);
            }
        }
    }
    if (tissue.empty())
        tissue.push_back(randomVoxel(random, size));
    const auto place = [&] { return tissue[random() % tissue.size()]; };
    if (random() % 3 == 0)
        made.steps.emplace_back(core::EngineCommand(
            core::SwapBricks{bricksOf(labelBoxes(size, 4, random), core::Field::Labels, 0)}));
    for (int burst = randomInt(random, 1, 3); burst > 0; --burst) {
        for (int label = randomInt(random, 1, 2); label > 0; --label)
            appendWhole(made.steps,
                core::SeedPlacement{.label = std::uint8_t(label), .voxels = {place(), place()}});
        GrowBurst grow{.lowCode = random() % 3 ? int(tissueCode) : 0,
            .highCode = tissueCode,
            .connectivity = std::array<int, 4>{6, 6, 18, 26}[random() % 4]};
        if (random() % 2)
            grow.overwritable.set(1).set(2).set(3).set(4);
        made.steps.emplace_back(BeginGrowth{grow});
        made.steps.emplace_back(core::EngineCommand(core::ExtendEdit{
            GrowAdvance{random() % 3 ? GrowAdvance::toClosure : randomInt(random, 1, 8)}}));
        made.steps.emplace_back(core::EngineCommand(core::EndEdit{}));
        for (int cuts = randomInt(random, 1, 2); cuts > 0; --cuts) {
            Cut cut = backwards({}, std::uint32_t(randomInt(random, 1, 5)));
            for (int i = randomInt(random, 1, 6); i > 0; --i)
                cut.cut.voxels.push_back(place());
            cut.cut.barrier = random() % 3 != 0;
            if (random() % 6 == 0)
                cut.cut.lockedLabels.set(std::size_t(randomInt(random, 1, 2)));
            for (int i = random() % 3 ? randomInt(random, 1, 4) : 0; i > 0; --i)
                cut.then.push_back(std::uint32_t(randomInt(random, 1, 12)));
            if (random() % 5 == 0)
                cut.ending = core::Ending::Rollback;
            made.steps.emplace_back(cut);
            if (random() % 3 == 0)
                made.steps.emplace_back(Undo{});
            if (random() % 3 == 0)
                made.steps.emplace_back(Redo{});
        }
    }
    return made;
}

} // namespace

std::vector<EngineCase> backwardCases(int randomCount)
{
    std::vector<EngineCase> cases;
    for (const int connectivity : {6, 26}) {
        for (const BackwardScene& scene : backwardScenes()) {
            EngineCase made = grown(scene, connectivity);
            const EngineStep growth = made.steps[made.steps.size() - 3];
            made.steps.emplace_back(backwards(scene.sketch, 1));
            made.steps.emplace_back(Undo{});
            made.steps.emplace_back(backwards(scene.sketch, 3));
            made.steps.emplace_back(Undo{});
            // Step by step to its end, and to and fro, which is forth.
            made.steps.emplace_back(backwards(scene.sketch, 1, {2, 3, 2, 5, 60}));
            made.steps.emplace_back(Undo{});
            made.steps.emplace_back(Redo{});
            made.steps.emplace_back(Undo{});
            made.steps.emplace_back(backwards(scene.sketch, 2, {4}, core::Ending::Rollback));
            Cut open = backwards(scene.sketch, 1, {4});
            open.cut.barrier = false;
            made.steps.emplace_back(open);
            // What was left open grows again.
            made.steps.push_back(growth);
            made.steps.emplace_back(core::EngineCommand(core::ExtendEdit{GrowAdvance{}}));
            made.steps.emplace_back(core::EngineCommand(core::EndEdit{}));
            made.steps.emplace_back(backwards(scene.seeds, 2)); // refused
            made.steps.emplace_back(backwards(scene.sketch, 60)); // as far as it goes, or refused
            cases.push_back(made);
        }
    }
    for (int i = 0; i < randomCount; ++i)
        cases.push_back(randomBackwards(i));
    return cases;
}

} // namespace test
