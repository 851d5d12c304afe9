// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"

namespace test {

namespace {

using core::EditableVoxels;
using core::LabelThreshold;
using core::RelabelListed;
using PlaneLabels = EditableVoxels::PlaneLabels;

/// Of one plane or two, of which the second holds less.
std::vector<PlaneLabels> randomPlanes(Random& random)
{
    std::vector<PlaneLabels> planes;
    for (std::uint8_t plane = 0; plane < 2; ++plane) {
        if (random() % 3 == 0)
            continue;
        PlaneLabels each{.plane = plane};
        for (std::size_t label = 1; label < 6; ++label)
            each.labels[label] = random() % 2;
        each.labels[255] = random() % 3 == 0;
        planes.push_back(each);
    }
    return planes;
}

EditableVoxels randomEditable(const glm::ivec3& size, Random& random)
{
    EditableVoxels editable;
    if (random() % 2)
        editable.lowCode = randomInt(random, -5, tissueCode / 2);
    if (random() % 2)
        editable.highCode = randomInt(random, random() % 8 ? tissueCode / 3 : -3, tissueCode);
    if (random() % 3 == 0) {
        const glm::ivec3 one = randomVoxel(random, size);
        const glm::ivec3 other = randomVoxel(random, size);
        editable.box = core::VoxelBox{
            glm::min(one, other) - int(random() % 2), glm::max(one, other) + int(random() % 3)};
    }
    if (random() % 2)
        editable.inside = randomPlanes(random);
    if (random() % 2)
        editable.outside = randomPlanes(random);
    return editable;
}

core::LabelTarget limitedTarget(std::uint8_t plane, Random& random)
{
    core::LabelTarget target{.plane = plane, .label = std::uint8_t(randomInt(random, 1, 4))};
    for (std::size_t label = 1; label < 6; ++label)
        target.overwritable[label] = random() % 3 == 0;
    return target;
}

RelabelListed limitedList(const glm::ivec3& size, std::uint8_t plane, Random& random)
{
    RelabelListed edit{.target = limitedTarget(plane, random)};
    for (int brick = 0; brick < core::BrickGrid{size}.brickCount(); ++brick) {
        if (random() % 3 == 0)
            continue;
        std::vector<std::uint8_t> asked(core::BrickGrid::voxelsPerBrick);
        for (std::uint8_t& each : asked)
            each = std::uint8_t(random() % 3);
        edit.bricks.push_back({.brick = std::uint32_t(brick), .asked = std::move(asked)});
    }
    return edit;
}

core::MapLabels randomTable(std::uint8_t plane, Random& random)
{
    core::MapLabels map{.plane = plane};
    for (std::size_t label = 0; label < 6; ++label) {
        if (random() % 2)
            map.becomes[label] = std::uint8_t(randomInt(random, 0, 5));
    }
    return map;
}

/// An outline through the middle of a volume, in a slice along the grid or leaning.
core::LabelOutlined limitedOutline(const core::Document& document, Random& random)
{
    const core::VolumeGeometry& geometry = document.volumes.front().geometry;
    core::FillOutline outline{.segment = 1,
        .originLps = geometry.toWorld((glm::dvec3(geometry.size) - 1.0) / 2.0),
        .rightLps = geometry.direction()[0],
        .upLps = geometry.direction()[1]};
    if (random() % 2)
        outline.upLps += geometry.direction()[2] * (randomUnit(random) - 0.5);
    outline.polygonMm = randomOutline(40.0, random);
    outline.erase = random() % 3 == 0;
    return core::labelOutlined(outline, document).value();
}

/// A curve over the middle of a volume, from a random side, to a depth or through everything.
core::LabelScissors limitedScissors(const core::Document& document, Random& random)
{
    const core::VolumeGeometry& geometry = document.volumes.front().geometry;
    const glm::dvec3 middle = geometry.toWorld((glm::dvec3(geometry.size) - 1.0) / 2.0);
    core::SegmentScissors scissors{.segment = 1,
        .view = {.eyeLps = middle
                + glm::dvec3(randomUnit(random) - 0.5, -1.0, randomUnit(random) - 0.5) * 200.0,
            .targetLps = middle,
            .up = {0.0, 0.0, 1.0},
            .heightMm = 80.0},
        .polygonMm = randomOutline(40.0, random)};
    scissors.erase = random() % 2;
    if (random() % 2)
        scissors.depthMm = 1.0 + 20.0 * randomUnit(random);
    else
        scissors.outside = random() % 2;
    return core::labelScissors(scissors, document).value();
}

/// A stroke that is told piece by piece, and once more from its end.
void appendLimited(std::vector<EngineStep>& steps, const core::PaintLabel& paint,
    const core::CapsulePath& path, core::Ending ending)
{
    steps.push_back(command(core::BeginEdit{paint}));
    steps.push_back(command(core::ExtendEdit{core::CapsulePath{path.capsules, path.under}}));
    for (std::size_t i = path.capsules.size(); i > 0 && i + 12 > path.capsules.size(); --i)
        steps.push_back(command(core::ExtendEdit{core::CapsulePath{{path.capsules[i - 1]}, {}}}));
    steps.push_back(command(core::EndEdit{ending}));
}

EngineCase randomlyLimited(int number)
{
    Random random(std::uint32_t(97000 + number));
    const int x = randomInt(random, 1, 40);
    const int y = randomInt(random, 1, 40);
    const int z = randomInt(random, 1, 40);
    const glm::ivec3 size(x, y, z);
    core::Document document = randomDocument(size, random, random() % 2 != 0);
    for (const std::uint8_t label : {std::uint8_t(1), std::uint8_t(2), std::uint8_t(255)})
        document.segments.push_back({.label = label, .plane = 0});
    EngineCase made{"random editable range " + QByteArray::number(number),
        noiseVolume(size, tissueCode, random), {}};
    for (std::uint8_t plane = 0; plane < 2; ++plane)
        made.steps.push_back(command(core::SwapBricks{
            bricksOf(labelBoxes(size, 6 - 3 * plane, random), core::Field::Labels, plane)}));
    Bytes carved = labelBoxes(size, 3, random);
    for (std::uint8_t& each : carved.values)
        each = std::uint8_t(each * 60); // less than half, half and more
    made.steps.push_back(command(core::SwapBricks{bricksOf(carved, core::Field::Coverage, 1)}));
    for (int edit = randomInt(random, 6, 12); edit > 0; --edit) {
        const auto plane = std::uint8_t(random() % 4 ? 0 : 1);
        const core::Ending ending = random() % 5 ? core::Ending::Commit : core::Ending::Rollback;
        const EditableVoxels editable = randomEditable(size, random);
        const int what = int(random() % 12);
        if (appendBetween(made.steps, what, plane, size, random))
            continue;
        switch (what) {
        case 11: {
            core::LabelScissors scissors = limitedScissors(document, random);
            scissors.target = limitedTarget(plane, random);
            scissors.editable = editable;
            appendWhole(made.steps, std::move(scissors), {}, ending);
            break;
        }
        case 9:
            appendWhole(made.steps, core::LabelCarved{limitedTarget(plane, random), 1, editable},
                {}, ending);
            break;
        case 10: {
            core::LabelSeen seen{.target = limitedTarget(plane, random)};
            seen.lowCode = randomInt(random, 0, tissueCode);
            seen.editable = editable;
            appendWhole(made.steps, std::move(seen), {}, ending);
            break;
        }
        case 3: {
            RelabelListed list = limitedList(size, plane, random);
            list.editable = editable;
            appendWhole(made.steps, std::move(list), {}, ending);
            break;
        }
        case 4: {
            core::MapLabels map = randomTable(plane, random);
            map.editable = editable;
            appendWhole(made.steps, std::move(map), {}, ending);
            break;
        }
        case 5: {
            LabelThreshold threshold{.target = limitedTarget(plane, random),
                .how = LabelThreshold::How(random() % 3),
                .lowCode = randomInt(random, 0, tissueCode),
                .editable = editable};
            appendWhole(made.steps, std::move(threshold), {}, ending);
            break;
        }
        case 6: {
            core::LabelOutlined outlined = limitedOutline(document, random);
            outlined.target = limitedTarget(plane, random);
            outlined.editable = editable;
            appendWhole(made.steps, std::move(outlined), {}, ending);
            break;
        }
        default: {
            const core::PaintStroke stroke = randomPaint(document, random);
            core::PaintLabel paint = core::paintLabel(stroke, document).value();
            paint.plane = plane;
            paint.editable = editable;
            appendLimited(made.steps, paint,
                core::paintPath(stroke, document.volumes.front().geometry), ending);
            break;
        }
        }
    }
    return made;
}

} // namespace

std::vector<EngineCase> editableCases(int randomCount)
{
    std::vector<EngineCase> cases;
    const glm::ivec3 size(33, 18, 20); // no multiple of a brick along any axis
    Random random(31);
    const Codes codes = noiseVolume(size, tissueCode, random);
    const core::LabelTarget third{.plane = 0, .label = 3};

    EngineCase planes{"an editable range of labels on two planes", codes, {}};
    for (std::uint8_t plane = 0; plane < 3; ++plane)
        planes.steps.push_back(command(
            core::SwapBricks{bricksOf(labelBoxes(size, 5, random), core::Field::Labels, plane)}));
    EditableVoxels editable{.lowCode = tissueCode / 4};
    const auto listed = [](std::uint8_t plane, std::initializer_list<std::size_t> labels) {
        PlaneLabels each{.plane = plane};
        for (const std::size_t label : labels)
            each.labels.set(label);
        return each;
    };
    const auto write = [&](core::LabelTarget target) {
        target.overwritable.set(1);
        appendWhole(planes.steps, LabelThreshold{.target = target, .editable = editable});
        planes.steps.push_back(Undo{});
    };
    write(third);
    editable.inside = {listed(2, {1, 2}), listed(1, {3})};
    write(third);
    editable.outside = {listed(0, {1}), listed(2, {2})};
    write(third);
    write({.plane = 1, .label = 1});
    editable.box = core::VoxelBox{{15, 0, 3}, {17, 9, 19}};
    write(third);
    editable.inside = std::vector<PlaneLabels>();
    write(third);
    editable.inside.reset();
    editable.highCode = -1;
    write(third);
    cases.push_back(planes);

    EngineCase refused{"editable ranges that are not sound", codes, {}};
    EditableVoxels wrong;
    wrong.outside = {listed(0, {1}), listed(0, {2})};
    appendWhole(refused.steps, LabelThreshold{.target = third, .editable = wrong});
    appendWhole(refused.steps, RelabelListed{.target = third, .editable = wrong});
    wrong.outside.clear();
    wrong.inside = {listed(1, {0})};
    appendWhole(refused.steps, core::MapLabels{.editable = wrong});
    cases.push_back(refused);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomlyLimited(number));
    return cases;
}

} // namespace test
