// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/EngineCases.h"

namespace test {

namespace {

using core::LabelOutlined;

constexpr std::int64_t millimetre = std::int64_t(1) << 30;
constexpr int millimetre16 = 1 << 16;

/// A slice of a volume whose voxels have sides of 1 mm.
LabelOutlined inSlice(int axis, int slice, std::vector<glm::ivec2> corners)
{
    LabelOutlined edit{.target = {.plane = 0, .label = 1}, .halfThickness = millimetre16 / 2};
    core::Fixed3* const steps[3]{&edit.perI, &edit.perJ, &edit.perK};
    (*steps[axis])[2] = millimetre;
    (*steps[(axis + 1) % 3])[0] = millimetre;
    (*steps[(axis + 2) % 3])[1] = millimetre;
    edit.origin[2] = -slice * millimetre;
    for (glm::ivec2& corner : corners)
        corner *= millimetre16;
    edit.corners = std::move(corners);
    return edit;
}

/// Any plane, any outline, some of whose corners are voxels, and some of whose edges are short, run
/// along an axis or back over themselves.
LabelOutlined randomOutlined(const glm::ivec3& size, std::uint8_t plane, Random& random)
{
    const auto component = [&random](int reach) {
        return std::int64_t(randomInt(random, -reach, reach)) << 20;
    };
    LabelOutlined edit{.target = {.plane = plane, .label = std::uint8_t(randomInt(random, 1, 4))}};
    if (random() % 3 == 0) {
        const int axis = randomInt(random, 0, 2);
        edit = inSlice(axis, randomInt(random, 0, size[axis]), {});
        edit.target = {.plane = plane, .label = std::uint8_t(randomInt(random, 1, 4))};
    } else {
        for (core::Fixed3* const step : {&edit.perI, &edit.perJ, &edit.perK}) {
            for (std::int64_t& each : *step)
                each = component(2048);
        }
        const glm::ivec3 through = randomVoxel(random, size);
        for (std::size_t axis = 0; axis < 3; ++axis)
            edit.origin[axis] = component(512) - through.x * edit.perI[axis]
                - through.y * edit.perJ[axis] - through.z * edit.perK[axis];
        edit.halfThickness = randomInt(random, 0, 3 * millimetre16);
    }
    for (std::size_t label = 1; label < 6; ++label)
        edit.target.overwritable[label] = random() % 3 == 0;
    edit.erase = random() % 4 == 0;
    if (random() % 3 == 0) {
        edit.lowCode = randomInt(random, -5, tissueCode);
        edit.highCode = randomInt(random, 0, tissueCode);
    }
    const auto placeOf = [&edit](const glm::ivec3& voxel) {
        glm::ivec2 place;
        for (int axis = 0; axis < 2; ++axis) {
            const auto at = std::size_t(axis);
            place[axis] = int(core::fixedPoint::round14(edit.origin[at] + voxel.x * edit.perI[at]
                + voxel.y * edit.perJ[at] + voxel.z * edit.perK[at]));
        }
        return place;
    };
    for (int i = randomInt(random, 3, random() % 8 ? 12 : 200); i > 0; --i) {
        glm::ivec2 corner = placeOf(randomVoxel(random, size));
        switch (random() % 5) {
        case 0:
            corner += glm::ivec2{randomInt(random, -99999, 99999), randomInt(random, -9, 9)};
            break;
        case 1:
            if (!edit.corners.empty())
                corner[int(random() % 2)] = edit.corners.back()[int(random() % 2)];
            break;
        case 2:
            if (edit.corners.size() > 1)
                corner = edit.corners[edit.corners.size() - 2];
            break;
        default:
            break;
        }
        edit.corners.push_back(corner);
    }
    return edit;
}

EngineCase randomOutlining(int number)
{
    Random random(std::uint32_t(83000 + number));
    const int x = randomInt(random, 1, 40);
    const int y = randomInt(random, 1, 40);
    const int z = randomInt(random, 1, 40);
    const glm::ivec3 size(x, y, z);
    EngineCase made{
        "random outlines " + QByteArray::number(number), noiseVolume(size, tissueCode, random), {}};
    if (random() % 3)
        made.steps.push_back(command(
            core::SwapBricks{bricksOf(labelBoxes(size, 6, random), core::Field::Labels, 0)}));
    for (int edit = randomInt(random, 4, 12); edit > 0; --edit) {
        const auto plane = std::uint8_t(random() % 6 ? 0 : 1);
        const int what = int(random() % 6);
        if (!appendBetween(made.steps, what, plane, size, random))
            appendWhole(made.steps, randomOutlined(size, plane, random), {},
                random() % 5 ? core::Ending::Commit : core::Ending::Rollback);
    }
    return made;
}

} // namespace

std::vector<EngineCase> outlineCases(int randomCount)
{
    std::vector<EngineCase> cases;
    const glm::ivec3 size(33, 18, 20); // no multiple of a brick along any axis
    Random random(11);
    const Codes codes = noiseVolume(size, 65535, random);

    EngineCase slices{"outlines in slices", codes, {}};
    for (int axis = 0; axis < 3; ++axis) {
        LabelOutlined square = inSlice(axis, 7, {{2, 3}, {30, 3}, {30, 15}, {2, 15}});
        appendWhole(slices.steps, square);
        square.lowCode = 32768;
        square.erase = true;
        appendWhole(slices.steps, square); // half of it again
        square.target.label = 2;
        square.erase = false;
        square.lowCode = 0;
        appendWhole(slices.steps, square); // only what is free
        square.target.overwritable.set(1);
        appendWhole(slices.steps, square, {}, core::Ending::Rollback);
        appendWhole(slices.steps, square);
    }
    for (int i = 0; i < 4; ++i)
        slices.steps.push_back(Undo{});
    slices.steps.push_back(Redo{});
    cases.push_back(slices);

    EngineCase shapes{"outlines of every shape", codes, {}};
    appendWhole(shapes.steps, inSlice(2, 3, {{1, 1}, {9, 9}, {9, 1}, {1, 9}})); // crosses itself
    appendWhole(shapes.steps,
        inSlice(2, 4, {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {9, 0}, {9, 9}, {0, 9}})); // twice
    appendWhole(shapes.steps,
        inSlice(2, 5, {{0, 0}, {12, 0}, {12, 9}, {8, 9}, {8, 3}, {4, 3}, {4, 9}, {0, 9}}));
    appendWhole(shapes.steps, inSlice(2, 6, {{3, 3}, {9, 9}, {6, 6}})); // a line
    appendWhole(shapes.steps, inSlice(2, 7, {{5, 5}, {5, 5}, {5, 5}})); // a voxel
    appendWhole(shapes.steps, inSlice(2, 8, {{-50, -50}, {90, -50}, {90, 90}, {-50, 90}}));
    appendWhole(shapes.steps, inSlice(2, 40, {{0, 0}, {9, 0}, {9, 9}})); // beside the volume
    appendWhole(shapes.steps, inSlice(2, 9, {{200, 0}, {209, 0}, {209, 9}}));
    for (int i = 0; i < 3; ++i)
        shapes.steps.push_back(Undo{});
    cases.push_back(shapes);

    EngineCase grown{"an outline among members and seeds", codes, {}};
    appendWhole(grown.steps, core::SeedPlacement{.label = 1, .voxels = {{0, 0, 0}, size / 2}});
    appendWhole(grown.steps, core::SeedPlacement{.label = 2, .voxels = {{1, 0, 0}, size - 1}});
    appendBurst(grown.steps, {.lowCode = 0, .highCode = 65535}, 6);
    LabelOutlined all = inSlice(2, size.z / 2, {{0, 0}, {32, 0}, {32, 17}, {0, 17}});
    all.target.overwritable.set(2);
    appendWhole(grown.steps, all);
    appendBurst(grown.steps, {.lowCode = 0, .highCode = 65535}, 3);
    all.erase = true;
    appendWhole(grown.steps, all);
    appendBurst(grown.steps, {.lowCode = 0, .highCode = 65535}, 3);
    for (int i = 0; i < 4; ++i)
        grown.steps.push_back(Undo{});
    cases.push_back(grown);

    EngineCase refused{"outlines that are not sound", codes, {}};
    const LabelOutlined sound = inSlice(0, 2, {{0, 0}, {9, 0}, {9, 9}});
    LabelOutlined wrong = sound;
    wrong.target.label = 0;
    appendWhole(refused.steps, wrong);
    wrong = sound;
    wrong.corners.pop_back();
    appendWhole(refused.steps, wrong);
    wrong = sound;
    wrong.corners.back().x = LabelOutlined::reach + 1;
    appendWhole(refused.steps, wrong);
    wrong = sound;
    wrong.corners.resize(LabelOutlined::mostCorners + 1, {0, 0});
    appendWhole(refused.steps, wrong);
    wrong = sound;
    wrong.halfThickness = -1;
    appendWhole(refused.steps, wrong);
    wrong = sound;
    wrong.perK[1] = std::int64_t(1) << 58;
    appendWhole(refused.steps, wrong);
    appendWhole(refused.steps, sound);
    cases.push_back(refused);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomOutlining(number));
    return cases;
}

} // namespace test
