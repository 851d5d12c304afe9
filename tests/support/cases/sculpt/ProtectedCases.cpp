// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"

namespace test {

namespace {

/// Labels 0 … 5 in runs, so that brushes meet some of each.
Bytes randomLabels(const glm::ivec3& size, Random& random)
{
    Bytes labels{size, {}};
    int label = 0;
    for (int i = size.x * size.y * size.z; i > 0; --i) {
        if (random() % 5 == 0)
            label = randomInt(random, 0, 5);
        labels.values.push_back(std::uint8_t(label));
    }
    return labels;
}

core::ProtectedLabels randomProtected(Random& random)
{
    core::ProtectedLabels protectedLabels;
    if (random() % 2)
        protectedLabels.planes = random() % 8; // of the first three, or of none
    for (std::size_t label = 0; label < 6; ++label)
        protectedLabels.labels[label] = random() % 3 == 0;
    protectedLabels.labels[255] = random() % 2;
    return protectedLabels;
}

void appendCut(EngineCase& made, int tool, const core::Document& scene, Random& random)
{
    const core::Ending ending = random() % 6 ? core::Ending::Commit : core::Ending::Rollback;
    const core::ProtectedLabels protectedLabels = randomProtected(random);
    if (tool == 0) {
        const core::Edit stroke = randomDrill(scene, random);
        core::DrillCut cut = drillCutOf(stroke, scene);
        cut.frame.protectedLabels = protectedLabels;
        appendWhole(made.steps, cut, {core::DrillPath{drillSamplesOf(stroke, cut)}}, ending);
    } else if (tool == 1) {
        const core::LaserStroke stroke = randomLaser(scene, random);
        core::LaserCut cut = *core::laserCut(stroke, scene);
        cut.frame.protectedLabels = protectedLabels;
        const core::DrillPath path{core::laserPath(stroke, cut)};
        appendWhole(made.steps, cut, {path}, ending);
    } else if (tool == 2) {
        const core::PeelCut peel = randomPeel(scene, random);
        core::ShellPeel cut = *core::shellPeel(peel, scene);
        cut.frame.protectedLabels = protectedLabels;
        // Deeper and back: what is put back is protected no less the next time.
        core::PeelDepth deeper = core::peelDepth(peel);
        deeper.depth *= 2;
        appendWhole(made.steps, cut, {deeper, core::peelDepth(peel)}, ending);
    } else if (tool == 3) {
        core::OutlineCut cut = *core::outlineCut(randomScissors(scene, random), scene);
        cut.frame.protectedLabels = protectedLabels;
        appendWhole(made.steps, cut, {}, ending);
    } else {
        const core::BrushStroke stroke = randomBrush(scene, random);
        core::CapsuleCut cut = *core::capsuleCut(stroke, scene);
        cut.protectedLabels = protectedLabels;
        const core::CapsulePath path{core::capsules(stroke.path, scene.volumes.front().geometry)};
        appendWhole(made.steps, cut, {path}, ending);
    }
}

} // namespace

std::vector<EngineCase> protectedCases(int randomCount)
{
    std::vector<EngineCase> cases;
    for (int number = 0; number < randomCount; ++number) {
        Random random(std::uint32_t(26000 + number));
        const glm::ivec3 size{
            randomInt(random, 8, 40), randomInt(random, 8, 40), randomInt(random, 8, 40)};
        const core::Document scene = randomDocument(size, random, number % 2 != 0);
        EngineCase made{"spared labels " + QByteArray::number(number),
            number % 3 ? balls(size, 4, random) : constantVolume(size, tissueCode), {}};
        for (const std::uint8_t plane : {std::uint8_t(0), std::uint8_t(1), std::uint8_t(2)})
            made.steps.push_back(core::EngineCommand(core::SwapBricks{
                bricksOf(randomLabels(size, random), core::Field::Labels, plane)}));
        for (int cut = 0; cut < 5; ++cut)
            appendCut(made, (number + cut) % 5, scene, random);
        made.steps.push_back(Undo{});
        appendCut(made, number % 5, scene, random);
        cases.push_back(std::move(made));
    }
    return cases;
}

} // namespace test
