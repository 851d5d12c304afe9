// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/scenes/CutEdits.h"

#include <algorithm>

namespace test {

namespace {

using core::DrillPath;
using core::DrillSample;
using core::LaserCut;
using core::LaserStroke;

Codes codesFor(const glm::ivec3& size, Random& random)
{
    switch (random() % 5) {
    case 0:
        return slab(size, randomInt(random, 0, 2), 2, 6);
    case 1:
        return shells(size);
    case 2:
        return noiseVolume(size, tissueCode, random);
    case 3:
        return constantVolume(size, tissueCode);
    default:
        return balls(size, randomInt(random, 2, 6), random);
    }
}

/// In pieces of a few samples; what is cut so far is read in between.
void append(EngineCase& made, const LaserCut& cut, const std::vector<DrillSample>& path,
    Random& random, core::Ending ending = core::Ending::Commit)
{
    made.steps.push_back(command(core::BeginEdit{cut}));
    for (std::size_t first = 0; first < path.size();) {
        const std::size_t last =
            std::min(path.size(), first + std::size_t(randomInt(random, 1, 9)));
        made.steps.push_back(command(core::ExtendEdit{DrillPath{
            {path.begin() + std::ptrdiff_t(first), path.begin() + std::ptrdiff_t(last)}}}));
        if (random() % 3 == 0)
            made.steps.push_back(
                command(core::ReadBricks{{{core::Field::Coverage, cut.layer, 0}}}));
        first = last;
    }
    made.steps.push_back(command(core::EndEdit{ending}));
}

void append(EngineCase& made, const LaserStroke& stroke, const core::Document& document,
    Random& random, core::Ending ending = core::Ending::Commit)
{
    const LaserCut cut = *core::laserCut(stroke, document);
    append(made, cut, core::laserPath(stroke, cut), random, ending);
}

/// Integers that a stroke would not have, within what the rules allow.
void disturb(LaserCut& cut, Random& random)
{
    core::CutFrame& frame = cut.frame;
    switch (random() % 12) {
    case 0:
        frame.gapSamples = randomInt(random, 1, 8);
        break;
    case 1:
        frame.thresholdCode = random() % 2 ? 0 : 65536;
        break;
    case 2:
        frame.sampleCount = randomInt(random, 0, frame.sampleCount);
        break;
    case 3:
        frame.rampHalfWidth = randomInt(random, 1, 3 * frame.rampHalfWidth);
        break;
    case 4:
        cut.normalStep = randomInt(random, 1, 2 * cut.normalStep);
        break;
    case 5:
        cut.lift = randomInt(random, 0, 4 * cut.lift);
        break;
    case 6:
        cut.laying = cut.laying == core::Laying::Carve ? core::Laying::Refill : core::Laying::Carve;
        break;
    case 7:
        frame.maxDepth /= 9;
        break;
    case 8:
        cut.mask.first += glm::ivec2{randomInt(random, -9, 9), randomInt(random, -9, 9)};
        break;
    default:
        break;
    }
}

EngineCase randomLasering(int number)
{
    Random random(std::uint32_t(31000 + number));
    const glm::ivec3 size{
        randomInt(random, 1, 26), randomInt(random, 1, 26), randomInt(random, 1, 26)};
    core::Document scene = randomDocument(size, random, random() % 2);
    if (random() % 4 == 0) { // slices far apart
        glm::dmat4& affine = scene.volumes.front().geometry.indexToWorld;
        affine[2] *= 8.0;
    }
    EngineCase made{"random laser " + QByteArray::number(number), codesFor(size, random), {}};
    for (int edit = randomInt(random, 1, 3); edit > 0; --edit) {
        switch (random() % 6) {
        case 0:
            made.steps.push_back(Undo{});
            break;
        case 1: {
            const core::Edit stroke = randomDrill(scene, random);
            const core::DrillCut cut = drillCutOf(stroke, scene);
            appendWhole(made.steps, cut, {DrillPath{drillSamplesOf(stroke, cut)}});
            break;
        }
        default: {
            const LaserStroke stroke = randomLaser(scene, random);
            LaserCut cut = *core::laserCut(stroke, scene);
            const std::vector<DrillSample> path = core::laserPath(stroke, cut);
            disturb(cut, random);
            append(made, cut, path, random,
                random() % 5 ? core::Ending::Commit : core::Ending::Rollback);
        }
        }
    }
    return made;
}

} // namespace

std::vector<EngineCase> laserCases(int randomCount)
{
    std::vector<EngineCase> cases;
    for (const glm::ivec3 small :
        {glm::ivec3(1, 1, 1), glm::ivec3(24, 17, 1), glm::ivec3(1, 40, 1), glm::ivec3(30, 22, 2)}) {
        Random random(30000);
        const core::Document scene = randomDocument(small, random, false);
        EngineCase made{"laser in " + QByteArray::number(small.x) + " x "
                + QByteArray::number(small.y) + " x " + QByteArray::number(small.z),
            constantVolume(small, tissueCode), {}};
        for (int i = 0; i < 3; ++i)
            append(made, randomLaser(scene, random), scene, random);
        cases.push_back(std::move(made));
    }
    {
        Random random(30001);
        const glm::ivec3 size(30, 26, 24);
        const core::Document scene = randomDocument(size, random, false);
        EngineCase made{"lasers over lasers in two layers", shells(size), {}};
        LaserStroke stroke = randomLaser(scene, random);
        stroke.view.targetLps = scene.volumes.front().geometry.toWorld(glm::dvec3(size) / 2.0);
        stroke.mask = {.radiusMm = 5.0};
        stroke.depthMm = 4.0;
        for (int i = 0; i < 5; ++i) {
            stroke.layer = 1 + i % 2;
            stroke.restore = i == 4;
            stroke.mode = i == 2 ? core::DrillMode::Rate : core::DrillMode::Limit;
            append(made, stroke, scene, random,
                i == 3 ? core::Ending::Rollback : core::Ending::Commit);
        }
        made.steps.push_back(Undo{});
        made.steps.push_back(Undo{});
        made.steps.push_back(Redo{});
        cases.push_back(std::move(made));
    }
    {
        Random random(30002);
        const glm::ivec3 size(20, 20, 20);
        const core::Document scene = randomDocument(size, random, false);
        const LaserCut laser = *core::laserCut(randomLaser(scene, random), scene);
        LaserCut noStep = laser;
        noStep.normalStep = 0;
        LaserCut wideStep = laser;
        wideStep.normalStep = 1 << 24;
        LaserCut noPitch = laser;
        noPitch.frame.pitch = 0;
        LaserCut sunk = laser;
        sunk.lift = -1;
        LaserCut hidden = laser;
        hidden.frame.hidden = {{{1 << 21, 0, 0}, 0}};
        EngineCase made{"lasers that are refused", balls(size, 4, random), {}};
        for (const core::EngineCommand& known : std::vector<core::EngineCommand>{
                 core::BeginEdit{noStep}, core::BeginEdit{wideStep}, core::BeginEdit{noPitch},
                 core::BeginEdit{sunk}, core::BeginEdit{hidden}, core::BeginEdit{laser},
                 core::ExtendEdit{core::PeelDepth{1}}, core::ExtendEdit{core::GrowPause{}},
                 core::EndEdit{core::Ending::Commit}, core::ExtendEdit{DrillPath{}}})
            made.steps.push_back(known);
        LaserCut noMask = laser;
        noMask.mask = {};
        appendWhole(made.steps, noMask, {DrillPath{{{.x = 0, .y = 0, .depth = 9999}}}});
        appendWhole(made.steps, laser, {DrillPath{}});
        cases.push_back(std::move(made));
    }
    for (const char* tool : {"laser", "drill", "peel", "scissors", "brush"}) {
        // A plane along the view, through the middle of what is cut: half of it is hidden.
        Random random(30003);
        const glm::ivec3 size(24, 24, 24);
        const core::Document scene = randomDocument(size, random, true);
        const core::VolumeGeometry& geometry = scene.volumes.front().geometry;
        const glm::dvec3 middle = geometry.toWorld(glm::dvec3(size) / 2.0);
        const glm::dvec3 towards = geometry.direction()[1];
        const glm::dvec3 side = glm::normalize(glm::cross(towards, geometry.direction()[2]));
        LaserStroke laser;
        laser.view.targetLps = middle;
        laser.view.eyeLps = middle - 200.0 * towards;
        laser.view.up = geometry.direction()[2];
        laser.mask.radiusMm = 5.0;
        laser.depthMm = 6.0;
        laser.surfaceThreshold = tissueCode / 2;
        laser.samples = {{.xMm = -2.0, .pressure = 1.0}};
        laser.hidden = {{{side, glm::dot(side, middle)}, {-towards, glm::dot(-towards, middle)}}};
        EngineCase made{
            QByteArray("half of it hidden, ") + tool, constantVolume(size, tissueCode), {}};
        const core::Edit drill = drillWith({.view = laser.view,
            .mask = laser.mask,
            .surfaceThreshold = laser.surfaceThreshold,
            .samples = laser.samples,
            .hidden = laser.hidden});
        core::PeelCut peel;
        peel.view = laser.view;
        peel.polygonMm = {{-5.0, -5.0}, {5.0, -5.0}, {5.0, 5.0}, {-5.0, 5.0}};
        peel.surfaceThreshold = laser.surfaceThreshold;
        peel.hidden = laser.hidden;
        core::ScissorsCut scissors;
        scissors.view = laser.view;
        scissors.polygonMm = peel.polygonMm;
        scissors.surfaceThreshold = laser.surfaceThreshold;
        scissors.hidden = laser.hidden;
        core::BrushStroke brush;
        brush.path.radiusMm = 5.0;
        brush.path.pointsLps = {middle, middle + 4.0 * side};
        brush.hidden = laser.hidden;
        const QByteArray name(tool);
        if (name == "laser") {
            append(made, laser, scene, random);
        } else if (name == "drill") {
            const core::DrillCut cut = drillCutOf(drill, scene);
            appendWhole(made.steps, cut, {DrillPath{drillSamplesOf(drill, cut)}});
        } else if (name == "peel") {
            appendWhole(made.steps, *core::shellPeel(peel, scene), {core::peelDepth(peel)});
        } else if (name == "scissors") {
            appendWhole(made.steps, *core::outlineCut(scissors, scene));
        } else {
            appendWhole(made.steps, *core::capsuleCut(brush, scene),
                {core::CapsulePath{core::capsules(brush.path, geometry)}});
        }
        cases.push_back(std::move(made));
    }
    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomLasering(number));
    return cases;
}

} // namespace test
