// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/scenes/CutEdits.h"

#include <initializer_list>

namespace test {

namespace {

EngineStep muted(std::initializer_list<int> layers)
{
    core::MuteLayers mute;
    for (const int layer : layers)
        mute.muted.set(std::size_t(layer));
    return command(mute);
}

/// Rays along every axis through the middle: what can be seen now.
EngineStep looks(const glm::ivec3& size)
{
    core::PickVoxels pick;
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 5; ++i) {
            core::PickRay ray;
            for (int other = 0; other < 3; ++other)
                ray.origin[other] = (size[other] - 1) * (i + 1) * 65536 / 6;
            ray.origin[axis] = 0;
            ray.step[axis] = 32768;
            ray.samples = 2 * size[axis];
            pick.rays.push_back(ray);
        }
    }
    pick.thresholdCode = tissueCode / 2;
    return command(pick);
}

Bytes ball(const glm::ivec3& size, const glm::dvec3& middle, double radius)
{
    Bytes bytes{size, {}};
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                bytes.values.push_back(
                    glm::distance(glm::dvec3(x, y, z), middle) < radius ? 255 : 0);
    return bytes;
}

void appendStroke(EngineCase& made, const core::Document& document, Random& random, int layer)
{
    const core::Edit stroke = drillWith({.layer = layer}, randomDrill(document, random));
    const core::DrillCut cut = drillCutOf(stroke, document);
    appendWhole(made.steps, cut, {core::DrillPath{drillSamplesOf(stroke, cut)}},
        random() % 6 ? core::Ending::Commit : core::Ending::Rollback);
}

EngineCase randomMuting(int number)
{
    Random random(std::uint32_t(14000 + number));
    const glm::ivec3 size{
        randomInt(random, 1, 40), randomInt(random, 1, 40), randomInt(random, 1, 40)};
    const core::Document document = randomDocument(size, random, random() % 2);
    EngineCase made{"random muting " + QByteArray::number(number),
        random() % 2 ? shells(size) : balls(size, 5, random), {}};
    for (int step = randomInt(random, 5, 12); step > 0; --step) {
        switch (random() % 7) {
        case 0:
            made.steps.push_back(Undo{});
            break;
        case 1:
            made.steps.push_back(Redo{});
            break;
        case 2:
        case 3: {
            core::MuteLayers mute;
            for (const std::size_t layer : {0, 1, 2, 255})
                mute.muted[layer] = random() % 2;
            made.steps.push_back(command(mute));
            break;
        }
        default:
            appendStroke(made, document, random, randomInt(random, 1, 2));
            break;
        }
        if (random() % 2)
            made.steps.push_back(looks(size));
    }
    return made;
}

} // namespace

std::vector<EngineCase> layerCases(int randomCount)
{
    std::vector<EngineCase> cases;
    const glm::ivec3 size(40, 33, 19);
    Random random(77);
    const core::Document document = randomDocument(size, random, false);
    const auto coverage = [&](const glm::dvec3& middle, std::uint8_t layer) {
        return command(
            core::SwapBricks{bricksOf(ball(size, middle, 9.0), core::Field::Coverage, layer)});
    };

    EngineCase apart{"muted layers beside and over each other", constantVolume(size, 1000), {}};
    apart.steps = {muted({1}), coverage({8, 8, 8}, 1), looks(size), coverage({12, 9, 8}, 2),
        looks(size), muted({}), looks(size), muted({2}), looks(size), muted({1, 2}), looks(size),
        coverage({30, 20, 18}, 2), muted({1}), looks(size), muted({1}), looks(size)};
    cases.push_back(apart);

    EngineCase strokes{"strokes see through muted layers", shells(size), {}};
    for (int i = 0; i < 3; ++i) {
        appendStroke(strokes, document, random, 1);
        strokes.steps.push_back(muted({1}));
        appendStroke(strokes, document, random, 2);
        strokes.steps.push_back(muted({2}));
        appendStroke(strokes, document, random, 1);
        appendStroke(strokes, document, random, 2); // into the muted one
        strokes.steps.push_back(looks(size));
        strokes.steps.push_back(muted({}));
    }
    for (int i = 0; i < 4; ++i)
        strokes.steps.push_back(Undo{});
    strokes.steps.push_back(muted({2}));
    strokes.steps.push_back(Redo{});
    strokes.steps.push_back(Redo{});
    strokes.steps.push_back(looks(size));
    cases.push_back(strokes);

    EngineCase open{"muting while an edit is open", shells(size), {}};
    appendStroke(open, document, random, 1);
    const core::Edit stroke = randomDrill(document, random);
    const core::DrillCut cut = drillCutOf(stroke, document);
    open.steps.push_back(command(core::BeginEdit{cut}));
    open.steps.push_back(muted({1}));
    open.steps.push_back(command(core::ExtendEdit{core::DrillPath{drillSamplesOf(stroke, cut)}}));
    open.steps.push_back(command(core::EndEdit{}));
    open.steps.push_back(looks(size));
    cases.push_back(open);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomMuting(number));
    return cases;
}

} // namespace test
