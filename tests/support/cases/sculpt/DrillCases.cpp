// SPDX-License-Identifier: Apache-2.0

#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"

#include <algorithm>

namespace test {

namespace {

using core::DrillCut;
using core::DrillPath;
using core::DrillSample;
using core::DrillStroke;

/// A case under construction: its document and its random numbers.
struct DrillScene {
    Random random;
    core::Document document;
    EngineCase made;

    DrillScene(QByteArray name, std::uint32_t seed, const glm::ivec3& size, bool sheared = false)
        : random(seed)
        , document(randomDocument(size, random, sheared))
        , made{std::move(name), {}, {}}
    {
    }

    [[nodiscard]] DrillStroke stroke() { return randomDrill(document, random).get<DrillStroke>(); }

    /// In pieces of a few samples; what is cut so far is read in between.
    void append(const DrillCut& cut, const std::vector<DrillSample>& path,
        core::Ending ending = core::Ending::Commit)
    {
        made.steps.push_back(command(core::BeginEdit{cut}));
        for (std::size_t first = 0; first < path.size();) {
            const std::size_t count =
                std::min<std::size_t>(path.size() - first, std::size_t(randomInt(random, 1, 6)));
            made.steps.push_back(
                command(core::ExtendEdit{DrillPath{{path.begin() + std::ptrdiff_t(first),
                    path.begin() + std::ptrdiff_t(first + count)}}}));
            if (random() % 3 == 0)
                made.steps.push_back(
                    command(core::ReadBricks{{{core::Field::Coverage, cut.layer, 0}}}));
            first += count;
        }
        made.steps.push_back(command(core::EndEdit{ending}));
    }

    void append(const DrillStroke& one, core::Ending ending = core::Ending::Commit)
    {
        const DrillCut cut = drillCutOf(one, document);
        append(cut, drillSamplesOf(one, cut), ending);
    }
};

Codes randomCodes(const glm::ivec3& size, Random& random)
{
    switch (random() % 5) {
    case 0:
        return noiseVolume(size, tissueCode, random);
    case 1:
        return slab(size, randomInt(random, 0, 2), 2, 5);
    case 2:
        return shells(size);
    case 3:
        return constantVolume(size, tissueCode);
    default:
        return balls(size, randomInt(random, 2, 6), random);
    }
}

/// Integers that a stroke would not have, within what the rules allow.
void disturb(DrillCut& cut, Random& random)
{
    core::CutFrame& frame = cut.frame;
    switch (random() % 9) {
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
        cut.maskRadius = randomInt(random, 0, frame.pitch * 2);
        break;
    case 5:
        frame.pitch = randomInt(random, frame.pitch / 2, frame.pitch * 3);
        break;
    case 6:
        cut.laying = cut.laying == core::Laying::Carve ? core::Laying::Refill : core::Laying::Carve;
        break;
    default:
        break;
    }
}

Bytes randomCoverage(const glm::ivec3& size, Random& random)
{
    Bytes bytes{size, {}};
    const bool sparse = random() % 2;
    for (int i = 0; i < size.x * size.y * size.z; ++i)
        bytes.values.push_back(
            sparse && random() % 8 ? std::uint8_t(0) : std::uint8_t(randomInt(random, 0, 255)));
    return bytes;
}

EngineCase randomDrilling(int number)
{
    Random random(std::uint32_t(5000 + number));
    const glm::ivec3 size{
        randomInt(random, 1, 40), randomInt(random, 1, 40), randomInt(random, 1, 40)};
    DrillScene scene("random drill " + QByteArray::number(number), std::uint32_t(6000 + number),
        size, random() % 2);
    scene.made.codes = randomCodes(size, random);
    if (random() % 3 == 0)
        scene.made.steps.push_back(command(
            core::SwapBricks{bricksOf(randomCoverage(size, random), core::Field::Coverage, 1)}));
    for (int edit = randomInt(random, 1, 5); edit > 0; --edit) {
        switch (random() % 6) {
        case 0:
            scene.made.steps.push_back(Undo{});
            break;
        case 1:
            scene.made.steps.push_back(Redo{});
            break;
        default: {
            const DrillStroke stroke = scene.stroke();
            DrillCut cut = drillCutOf(stroke, scene.document);
            const auto path = drillSamplesOf(stroke, cut);
            disturb(cut, random);
            scene.append(cut, path, random() % 5 ? core::Ending::Commit : core::Ending::Rollback);
            break;
        }
        }
    }
    return std::move(scene.made);
}

core::PickRay randomRay(const glm::ivec3& size, Random& random)
{
    core::PickRay ray;
    const glm::ivec3 a = randomVoxel(random, size);
    const glm::ivec3 b = randomVoxel(random, size);
    const int samples = randomInt(random, 1, 60);
    for (int axis = 0; axis < 3; ++axis) {
        const int from = (a[axis] << 16) + randomInt(random, -65536, 65536);
        const int to = (b[axis] << 16) + randomInt(random, -65536, 65536);
        ray.origin[axis] = from;
        ray.step[axis] = (to - from) / samples;
    }
    if (random() % 4 == 0)
        ray.step[randomInt(random, 0, 2)] = 0;
    ray.samples = random() % 10 ? samples * 2 : 0;
    return ray;
}

core::PickVoxels randomPick(const glm::ivec3& size, Random& random)
{
    core::PickVoxels pick;
    for (int i = randomInt(random, 0, 40); i > 0; --i)
        pick.rays.push_back(randomRay(size, random));
    pick.seenBy = core::SeenBy(random() % 4);
    for (std::size_t label = 1; label < 5; ++label)
        pick.segments[label] = random() % 2;
    pick.thresholdCode = random() % 6 ? randomInt(random, 0, tissueCode) : 65536;
    if (pick.seenBy == core::SeenBy::Opacity) {
        const int highest = random() % 3 ? 9000 : 65535;
        for (int i = 0; i < 256; ++i)
            pick.opacityOfCode.push_back(
                random() % 4 ? std::uint32_t(randomInt(random, 0, highest)) : 0u);
    }
    return pick;
}

} // namespace

std::vector<EngineCase> drillCases(int randomCount)
{
    std::vector<EngineCase> cases;
    const auto add = [&](DrillScene& scene) { cases.push_back(std::move(scene.made)); };
    const glm::ivec3 size(33, 20, 17);

    for (const char* name : {"one voxel", "one slice", "one row"}) {
        const glm::ivec3 small = name[4] == 'v' ? glm::ivec3(1, 1, 1)
            : name[4] == 's'                    ? glm::ivec3(24, 17, 1)
                                                : glm::ivec3(1, 40, 1);
        DrillScene scene(QByteArray("drill ") + name, 1, small);
        scene.made.codes = constantVolume(small, tissueCode);
        for (int i = 0; i < 3; ++i)
            scene.append(scene.stroke());
        add(scene);
    }
    for (const int threshold : {0, 1, int(tissueCode), tissueCode + 1, 65536}) {
        DrillScene scene("drill, threshold " + QByteArray::number(threshold), 2, size);
        scene.made.codes = balls(size, 5, scene.random);
        DrillStroke stroke = scene.stroke();
        stroke.depthMm = 9.0;
        stroke.mask.radiusMm = 7.0;
        stroke.surfaceThreshold = threshold;
        scene.append(stroke);
        add(scene);
    }
    {
        DrillScene scene("drill without pressure", 3, size);
        scene.made.codes = constantVolume(size, tissueCode);
        DrillStroke stroke = scene.stroke();
        for (core::PenSample& sample : stroke.samples)
            sample.pressure = 0.0;
        scene.append(stroke);
        stroke.depthMm = 0.0;
        stroke.samples.front().pressure = 1.0;
        scene.append(stroke);
        add(scene);
    }
    {
        DrillScene scene("drill without a path, or beside the volume", 4, size);
        scene.made.codes = constantVolume(size, tissueCode);
        DrillStroke stroke = scene.stroke();
        const DrillCut cut = drillCutOf(stroke, scene.document);
        scene.append(cut, {});
        appendWhole(scene.made.steps, cut, {DrillPath{}});
        for (core::PenSample& sample : stroke.samples)
            sample.xMm += 500.0;
        scene.append(stroke);
        add(scene);
    }
    for (const bool throughGaps : {false, true}) {
        DrillScene scene(throughGaps ? "slabs, through gaps" : "slabs", 5, {30, 30, 30});
        scene.made.codes = slab({30, 30, 30}, 1, 4, 8);
        for (int y = 17; y < 22; ++y)
            for (int z = 0; z < 30; ++z)
                for (int x = 0; x < 30; ++x)
                    scene.made.codes.at({x, y, z}) = tissueCode;
        DrillStroke stroke = scene.stroke();
        const core::VolumeGeometry& geometry = scene.document.volumes.front().geometry;
        stroke.view.targetLps = geometry.toWorld({15.0, 15.0, 15.0});
        stroke.view.eyeLps = stroke.view.targetLps - 100.0 * geometry.direction()[1];
        stroke.view.up = geometry.direction()[2];
        stroke.depthMm = 100.0;
        stroke.mask.radiusMm = 5.0;
        stroke.throughGaps = throughGaps;
        stroke.samples = {{.xMm = 0.0, .yMm = 0.0}, {.xMm = 6.0, .yMm = 3.0}};
        scene.append(stroke);
        add(scene);
    }
    {
        DrillScene scene("strokes over strokes in two layers", 6, size);
        scene.made.codes = shells(size);
        DrillStroke stroke = scene.stroke();
        stroke.mask.radiusMm = 6.0;
        stroke.depthMm = 4.0;
        for (int i = 0; i < 6; ++i) {
            stroke.layer = 1 + i % 2;
            scene.append(stroke, i == 3 ? core::Ending::Rollback : core::Ending::Commit);
        }
        scene.made.steps.push_back(Undo{});
        scene.made.steps.push_back(Undo{});
        scene.append(stroke);
        scene.made.steps.push_back(Undo{});
        scene.made.steps.push_back(Redo{});
        add(scene);
    }
    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomDrilling(number));
    return cases;
}

std::vector<EngineCase> pickCases(int randomCount)
{
    std::vector<EngineCase> cases;
    for (int number = 0; number < randomCount; ++number) {
        Random random(std::uint32_t(9000 + number));
        const glm::ivec3 size{
            randomInt(random, 1, 30), randomInt(random, 1, 30), randomInt(random, 1, 30)};
        DrillScene scene("picks " + QByteArray::number(number), std::uint32_t(9500 + number), size);
        scene.made.codes = randomCodes(size, random);
        std::vector<EngineStep>& steps = scene.made.steps;
        for (const std::uint8_t plane : {std::uint8_t(0), std::uint8_t(1)}) {
            if (random() % 3)
                steps.push_back(command(core::SwapBricks{
                    bricksOf(labelBoxes(size, 5, random), core::Field::Labels, plane)}));
        }
        steps.push_back(command(randomPick(size, random)));
        for (const std::uint8_t layer : {std::uint8_t(1), std::uint8_t(2)}) {
            if (random() % 2)
                steps.push_back(command(core::SwapBricks{
                    bricksOf(randomCoverage(size, random), core::Field::Coverage, layer)}));
            steps.push_back(command(randomPick(size, random)));
        }
        // A pick in the middle of a stroke sees what the stroke has cut.
        const DrillStroke stroke = scene.stroke();
        const DrillCut cut = drillCutOf(stroke, scene.document);
        steps.push_back(command(core::BeginEdit{cut}));
        steps.push_back(command(randomPick(size, random)));
        steps.push_back(command(core::ExtendEdit{DrillPath{drillSamplesOf(stroke, cut)}}));
        steps.push_back(command(randomPick(size, random)));
        steps.push_back(command(core::EndEdit{core::Ending::Rollback}));
        steps.push_back(command(randomPick(size, random)));
        scene.append(scene.stroke());
        steps.push_back(command(randomPick(size, random)));
        cases.push_back(std::move(scene.made));
    }
    return cases;
}

} // namespace test
