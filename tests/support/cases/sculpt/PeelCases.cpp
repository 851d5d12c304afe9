// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"

#include <algorithm>

namespace test {

namespace {

core::Document document(const glm::ivec3& size, Random& random, const glm::dvec3& spacing)
{
    core::Document made = randomDocument(size, random, random() % 2);
    glm::dmat4& affine = made.volumes.front().geometry.indexToWorld;
    for (int axis = 0; axis < 3; ++axis)
        affine[axis] = glm::dvec4(glm::normalize(glm::dvec3(affine[axis])) * spacing[axis], 0.0);
    return made;
}

Codes peelCodesFor(const glm::ivec3& size, Random& random)
{
    switch (random() % 4) {
    case 0:
        return slab(size, randomInt(random, 0, 2), 2, 6);
    case 1:
        return shells(size);
    case 2:
        return noiseVolume(size, tissueCode, random);
    default:
        return balls(size, randomInt(random, 2, 6), random);
    }
}

/// Depths told one after the other, up and down; what is cut so far is read in between.
void appendPeel(std::vector<EngineStep>& steps, const core::ShellPeel& peel, std::int32_t depth,
    Random& random, core::Ending ending)
{
    steps.push_back(command(core::BeginEdit{peel}));
    for (int i = randomInt(random, 0, 3); i > 0; --i) {
        const auto other = std::int32_t(2.0 * depth * randomUnit(random));
        steps.push_back(command(core::ExtendEdit{core::PeelDepth{random() % 5 ? other : 0}}));
        if (random() % 2)
            steps.push_back(command(core::ReadBricks{{{core::Field::Coverage, peel.layer, 0}}}));
    }
    steps.push_back(command(core::ExtendEdit{core::PeelDepth{depth}}));
    steps.push_back(command(core::EndEdit{ending}));
}

EngineCase randomPeeling(int number)
{
    Random random(std::uint32_t(21000 + number));
    const glm::ivec3 size{
        randomInt(random, 1, 32), randomInt(random, 1, 32), randomInt(random, 1, 32)};
    const double finest = 0.5 + randomUnit(random);
    const glm::dvec3 spacing = random() % 3 == 0 ? glm::dvec3(finest, finest, 8.0 * finest)
        : random() % 2                           ? glm::dvec3(finest, finest, 5.0 * finest)
                                                 : glm::dvec3(finest);
    const core::Document scene = document(size, random, spacing);
    EngineCase made{"random peel " + QByteArray::number(number), peelCodesFor(size, random), {}};
    for (int edit = randomInt(random, 1, 4); edit > 0; --edit) {
        const core::Ending ending = random() % 6 ? core::Ending::Commit : core::Ending::Rollback;
        switch (random() % 5) {
        case 0: {
            core::PeelCut edited = randomPeel(scene, random);
            core::ShellPeel peel = *core::shellPeel(edited, scene);
            if (random() % 6 == 0)
                peel.laying = core::Laying::Carve;
            if (random() % 6 == 0)
                peel.frame.maxDepth /= 20;
            appendPeel(made.steps, peel, core::peelDepth(edited).depth, random, ending);
            break;
        }
        case 1: {
            const core::PeelCut edited = randomPeel(scene, random);
            appendWhole(made.steps, *core::shellPeel(edited, scene), {core::peelDepth(edited)});
            break;
        }
        case 2:
            made.steps.push_back(Undo{});
            break;
        case 3: {
            const core::Edit stroke = randomDrill(scene, random);
            const core::DrillCut cut = drillCutOf(stroke, scene);
            appendWhole(made.steps, cut, {core::DrillPath{drillSamplesOf(stroke, cut)}});
            break;
        }
        default:
            appendWhole(
                made.steps, *core::outlineCut(randomScissors(scene, random), scene), {}, ending);
        }
    }
    return made;
}

} // namespace

std::vector<EngineCase> peelCases(int randomCount)
{
    std::vector<EngineCase> cases;
    {
        Random random(20000);
        const glm::ivec3 size(30, 26, 24);
        const core::Document scene = document(size, random, glm::dvec3(1.0));
        EngineCase made{"peels over peels", shells(size), {}};
        for (int i = 0; i < 4; ++i) {
            core::PeelCut peel = randomPeel(scene, random);
            peel.view.targetLps = scene.volumes.front().geometry.toWorld(glm::dvec3(size) / 2.0);
            peel.layer = 1 + i % 2;
            peel.depthMm = 3.0 + i;
            peel.restore = i == 3;
            appendPeel(made.steps, *core::shellPeel(peel, scene), core::peelDepth(peel).depth,
                random, core::Ending::Commit);
        }
        made.steps.push_back(Undo{});
        made.steps.push_back(Undo{});
        made.steps.push_back(Redo{});
        cases.push_back(std::move(made));
    }
    {
        Random random(20001);
        const glm::ivec3 size(20, 20, 20);
        const core::Document scene = document(size, random, glm::dvec3(1.0));
        const core::PeelCut edited = randomPeel(scene, random);
        core::ShellPeel peel = *core::shellPeel(edited, scene);
        core::OutlineCut scissors = *core::outlineCut(randomScissors(scene, random), scene);
        core::ShellPeel unsound = peel;
        unsound.frame.pitch = 0;
        scissors.frame.gapSamples = 0;
        EngineCase made{"peels that are refused", balls(size, 4, random), {}};
        for (const core::EngineCommand& known :
            std::vector<core::EngineCommand>{core::BeginEdit{unsound}, core::BeginEdit{scissors},
                core::BeginEdit{peel}, core::ExtendEdit{core::DrillPath{}},
                core::ExtendEdit{core::PeelDepth{-1}}, core::ExtendEdit{core::GrowPause{}},
                core::EndEdit{core::Ending::Commit}, core::ExtendEdit{core::PeelDepth{1}}})
            made.steps.push_back(known);
        peel.mask = {};
        appendWhole(made.steps, peel, {core::PeelDepth{65536}});
        cases.push_back(std::move(made));
    }
    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomPeeling(number));
    return cases;
}

std::vector<EngineCase> scissorsCases(int randomCount)
{
    std::vector<EngineCase> cases;
    for (int number = 0; number < randomCount; ++number) {
        Random random(std::uint32_t(23000 + number));
        const glm::ivec3 size{
            randomInt(random, 1, 32), randomInt(random, 1, 32), randomInt(random, 1, 32)};
        const glm::dvec3 spacing(1.0, 1.0, random() % 3 ? 1.0 : 8.0);
        const core::Document scene = document(size, random, spacing);
        EngineCase made{
            "random scissors " + QByteArray::number(number), peelCodesFor(size, random), {}};
        for (const bool restore : {false, true}) {
            core::ScissorsCut cut = randomScissors(scene, random);
            cut.restore = restore;
            cut.firstLayerOnly = cut.firstLayerOnly && !restore;
            appendWhole(made.steps, *core::outlineCut(cut, scene), {},
                random() % 8 ? core::Ending::Commit : core::Ending::Rollback);
        }
        if (random() % 2)
            made.steps.push_back(Undo{});
        cases.push_back(std::move(made));
    }
    return cases;
}

} // namespace test
