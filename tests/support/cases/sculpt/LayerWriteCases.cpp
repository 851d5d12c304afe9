// SPDX-License-Identifier: Apache-2.0

#include "tests/support/cases/EngineCases.h"
#include <array>
#include <functional>

namespace test {

namespace {

using core::CoverLabel;
using core::FoldLayer;
using core::LabelCarved;
using core::LabelListed;
using core::LabelSeen;
using core::LabelTarget;
using core::VoxelBound;

Bytes noise(const glm::ivec3& size, Random& random, std::initializer_list<int> values)
{
    Bytes bytes{size, {}};
    const std::vector<int> list(values);
    const bool sparse = random() % 3 == 0;
    for (int i = size.x * size.y * size.z; i > 0; --i)
        bytes.values.push_back(
            sparse && random() % 60 ? std::uint8_t(0) : std::uint8_t(list[random() % list.size()]));
    return bytes;
}

EngineStep put(const Bytes& bytes, core::Field field, std::uint8_t plane)
{
    return command(core::SwapBricks{bricksOf(bytes, field, plane)});
}

VoxelBound randomBound(const glm::ivec3& size, Random& random)
{
    VoxelBound bound;
    glm::ivec3 through(0);
    std::int64_t sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const int most = ((1 << 29) - 1) / size[axis];
        bound.normal[axis] = random() % 4 ? randomInt(random, -most, most) : 0;
        through[axis] = randomInt(random, 0, size[axis] - 1);
        sum += std::int64_t(bound.normal[axis]) * through[axis];
    }
    bound.offset = std::int32_t(sum);
    return bound;
}

LabelTarget randomTarget(Random& random, std::uint8_t plane)
{
    LabelTarget target{.plane = plane, .label = std::uint8_t(randomInt(random, 1, 4))};
    for (int label = 1; label < 6; ++label)
        target.overwritable[std::size_t(label)] = random() % 3 == 0;
    return target;
}

/// Labels asked for in some bricks, about every third voxel.
LabelListed randomList(const glm::ivec3& size, std::uint8_t plane, Random& random)
{
    LabelListed list{.plane = plane};
    for (int label = 1; label < 6; ++label)
        list.overwritable[std::size_t(label)] = random() % 3 == 0;
    for (int brick = 0; brick < core::BrickGrid{size}.brickCount(); ++brick) {
        if (random() % 3 == 0)
            continue;
        std::vector<std::uint8_t> labels(core::BrickGrid::voxelsPerBrick);
        for (std::uint8_t& label : labels)
            label = random() % 3 ? 0 : std::uint8_t(randomInt(random, 1, 255) % 7);
        list.bricks.push_back({.brick = std::uint32_t(brick), .labels = std::move(labels)});
    }
    return list;
}

/// Lists for some of three planes, most of which leave alone what others hold.
core::LabelPlanes randomPlaneLists(const glm::ivec3& size, Random& random)
{
    constexpr int planes = 3;
    core::LabelPlanes made;
    for (int plane = 0; plane < planes; ++plane) {
        if (plane != 1 && random() % 4 == 0)
            continue;
        LabelListed list = randomList(size, std::uint8_t(plane), random);
        list.frees = random() % 2 ? 6 : 0;
        if (random() % 4) {
            core::EditableVoxels& editable = list.editable.emplace();
            for (int other = 0; other < planes; ++other) {
                core::EditableVoxels::PlaneLabels kept{.plane = std::uint8_t(other), .labels = {}};
                for (int label = 1; label < 7; ++label)
                    kept.labels[std::size_t(label)] = random() % 2;
                if (other != plane)
                    editable.outside.push_back(kept);
            }
        }
        made.planes.push_back(std::move(list));
    }
    return made;
}

/// Tables for some of three planes, in any order, most of which keep to what another plane holds by
/// then.
core::MapPlanes randomMaps(Random& random)
{
    constexpr int planes = 3;
    core::MapPlanes made;
    const int begin = randomInt(random, 0, planes - 1);
    const int step = randomInt(random, 1, planes - 1);
    for (int i = 0; i < planes; ++i) {
        if (i != 1 && random() % 4 == 0)
            continue;
        core::MapLabels map{.plane = std::uint8_t((begin + i * step) % planes)};
        for (std::size_t label = 0; label < 6; ++label) {
            if (random() % 3 == 0)
                map.becomes[label] = std::uint8_t(randomInt(random, 0, 5));
        }
        if (random() % 4) {
            core::EditableVoxels::PlaneLabels beside{
                .plane = std::uint8_t((map.plane + 1 + random() % 2) % planes), .labels = {}};
            for (int label = 1; label < 6; ++label)
                beside.labels[std::size_t(label)] = random() % 2;
            if (random() % 3)
                map.editable.emplace().inside = {beside};
            else
                map.editable.emplace().outside = {beside};
        }
        made.planes.push_back(map);
    }
    return made;
}

/// Six edits of three planes, each behind seeds in one of them; one is rolled back, and some are
/// undone and redone.
/// @param seededPlanes in how many of the planes there are seeds
/// @param rolledBack which of the edits
/// @param write makes the next edit
EngineCase writesInPlanes(const QByteArray& name, const glm::ivec3& size, Random random,
    int seededPlanes, int rolledBack, const std::function<core::EngineEdit(Random&)>& write)
{
    EngineCase made{name, constantVolume(size, tissueCode), {}};
    for (int plane = 0; plane < 3; ++plane)
        made.steps.push_back(
            put(noise(size, random, {0, 0, 0, 1, 2, 5}), core::Field::Labels, std::uint8_t(plane)));
    for (int edit = 0; edit < 6; ++edit) {
        core::SeedPlacement seeds{.plane = std::uint8_t(edit % seededPlanes),
            .label = std::uint8_t(randomInt(random, 1, 4)),
            .voxels = {}};
        appendSeeds(made.steps, seeds, 5, size, random);
        appendWhole(made.steps, write(random), {},
            edit == rolledBack ? core::Ending::Rollback : core::Ending::Commit);
        if (edit == 4)
            made.steps.push_back(Undo{});
    }
    for (int i = 0; i < 4; ++i)
        made.steps.push_back(Undo{});
    for (int i = 0; i < 3; ++i)
        made.steps.push_back(Redo{});
    return made;
}

EngineCase planeWrites(int number, const glm::ivec3& size)
{
    return writesInPlanes("labels listed in several planes " + QByteArray::number(number), size,
        Random(std::uint32_t(21900 + number)), 2, 3,
        [&size](Random& random) { return randomPlaneLists(size, random); });
}

EngineCase mapWrites(int number, const glm::ivec3& size)
{
    return writesInPlanes("labels mapped in several planes " + QByteArray::number(number), size,
        Random(std::uint32_t(21950 + number)), 3, 2,
        [](Random& random) { return randomMaps(random); });
}

EngineCase randomWrites(int number)
{
    Random random(std::uint32_t(21000 + number));
    const glm::ivec3 size{
        randomInt(random, 1, 40), randomInt(random, 1, 40), randomInt(random, 1, 40)};
    EngineCase made{"random layer writes " + QByteArray::number(number),
        noiseVolume(size, tissueCode, random), {}};
    made.steps.push_back(put(noise(size, random, {0, 127, 128, 255}), core::Field::Coverage, 1));
    made.steps.push_back(put(noise(size, random, {0, 1, 127, 128, 200}), core::Field::Coverage, 2));
    if (random() % 3)
        made.steps.push_back(put(noise(size, random, {0, 0, 1, 2, 5}), core::Field::Labels, 0));
    for (int edit = randomInt(random, 4, 12); edit > 0; --edit) {
        const auto plane = std::uint8_t(random() % 6 ? 0 : 1);
        const auto layer = std::uint8_t(random() % 2 + 1);
        const core::Ending ending = random() % 5 ? core::Ending::Commit : core::Ending::Rollback;
        switch (random() % 10) {
        case 0: {
            core::SeedPlacement seeds{
                .plane = plane, .label = std::uint8_t(randomInt(random, 1, 4)), .voxels = {}};
            appendSeeds(made.steps, seeds, randomInt(random, 0, 4), size, random);
            break;
        }
        case 1:
            made.steps.push_back(BeginGrowth{{.plane = plane, .lowCode = 0, .highCode = 65535}});
            made.steps.push_back(command(core::ExtendEdit{core::GrowAdvance{3}}));
            made.steps.push_back(command(core::EndEdit{}));
            break;
        case 2:
            appendWhole(made.steps, LabelCarved{randomTarget(random, plane), layer}, {}, ending);
            break;
        case 3:
        case 4: {
            LabelSeen seen{.target = randomTarget(random, plane)};
            if (random() % 2)
                seen.lowCode = randomInt(random, 0, tissueCode);
            if (random() % 3 == 0)
                seen.highCode = randomInt(random, 0, tissueCode);
            for (int i = randomInt(random, 0, 3); i > 0; --i)
                seen.bounds.push_back(randomBound(size, random));
            appendWhole(made.steps, std::move(seen), {}, ending);
            break;
        }
        case 5: {
            CoverLabel cover{.layer = std::uint8_t(random() % 3 ? layer : 0),
                .plane = plane,
                .label = std::uint8_t(randomInt(random, 1, 5))};
            cover.outside = random() % 3 == 0;
            if (random() % 2)
                cover.protectedLabels.set(std::size_t(randomInt(random, 0, 5)));
            appendWhole(made.steps, cover, {}, ending);
            break;
        }
        case 6: {
            FoldLayer fold{.layer = layer, .into = {}};
            if (random() % 3)
                fold.into = std::uint8_t(3 - layer);
            appendWhole(made.steps, fold, {}, ending);
            break;
        }
        case 7: {
            core::MuteLayers mute;
            mute.muted[layer] = random() % 2;
            made.steps.push_back(command(mute));
            break;
        }
        case 8:
            appendWhole(made.steps, randomList(size, plane, random), {}, ending);
            break;
        default:
            made.steps.push_back(random() % 2 ? EngineStep(Undo{}) : EngineStep(Redo{}));
            break;
        }
    }
    return made;
}

} // namespace

std::vector<EngineCase> layerWriteCases(int randomCount)
{
    std::vector<EngineCase> cases;
    const glm::ivec3 size(33, 18, 20); // no multiple of a brick along any axis
    const Codes codes = constantVolume(size, tissueCode);
    Random random(5);
    const LabelTarget first{.plane = 0, .label = 1};

    EngineCase nothing{"layer writes where there is nothing", codes, {}};
    appendWhole(nothing.steps, LabelCarved{first, 1});
    appendWhole(nothing.steps, LabelCarved{first, 7});
    appendWhole(nothing.steps, CoverLabel{.layer = 1, .plane = 0, .label = 1});
    appendWhole(nothing.steps, FoldLayer{.layer = 1, .into = 2});
    appendWhole(nothing.steps, FoldLayer{.layer = 2});
    appendWhole(nothing.steps, LabelSeen{.target = first, .lowCode = 5, .highCode = 4});
    appendWhole(nothing.steps, LabelSeen{.target = first, .lowCode = 70000, .highCode = 65535});
    appendWhole(nothing.steps, LabelSeen{.target = first, .lowCode = 0, .highCode = -1});
    cases.push_back(nothing);

    EngineCase corners{"everything to the corners", codes, {}};
    appendWhole(corners.steps, LabelSeen{.target = first});
    appendWhole(corners.steps, CoverLabel{.layer = 1, .plane = 0, .label = 1});
    appendWhole(corners.steps, LabelSeen{.target = {.plane = 0, .label = 2}}); // all is carved
    core::MuteLayers mute;
    mute.muted.set(1);
    corners.steps.push_back(command(mute));
    LabelTarget taker{.plane = 0, .label = 2};
    appendWhole(corners.steps, LabelSeen{.target = taker}); // nothing is free
    taker.overwritable.set(1);
    appendWhole(corners.steps, LabelCarved{taker, 1});
    appendWhole(corners.steps, FoldLayer{.layer = 1, .into = 2});
    corners.steps.push_back(Undo{});
    corners.steps.push_back(Undo{});
    corners.steps.push_back(Redo{});
    corners.steps.push_back(command(core::ProbeVoxels{{{0, 0, 0}, size - 1}}));
    CoverLabel all{.layer = 3, .plane = 0, .label = 9, .outside = true};
    all.protectedLabels.set(1);
    all.protectedLabels.set(2);
    appendWhole(corners.steps, all); // nothing is anyone else's
    all.protectedLabels.reset();
    appendWhole(corners.steps, all);
    appendWhole(corners.steps, all); // all is carved
    corners.steps.push_back(Undo{});
    cases.push_back(corners);

    EngineCase bounds{"bounds meet voxels exactly", codes, {}};
    const int step = ((1 << 29) - 1) / 33;
    const VoxelBound low{{-step, 0, 0}, -4 * step};
    const VoxelBound high{{step, 0, 0}, 9 * step};
    const VoxelBound oblique{{step, step, -step}, 5 * step};
    appendWhole(bounds.steps, LabelSeen{.target = first, .bounds = {low, high}});
    appendWhole(bounds.steps, LabelSeen{.target = {.plane = 1, .label = 3}, .bounds = {oblique}});
    appendWhole(
        bounds.steps, LabelSeen{.target = {.plane = 0, .label = 9}, .bounds = {{{0, 0, 0}, -1}}});
    appendWhole(bounds.steps,
        LabelSeen{.target = {.plane = 0, .label = 9}, .bounds = {{{0, 0, 0}, 2147483647}}});
    cases.push_back(bounds);

    EngineCase grown{"growth ends where its words are taken", codes, {}};
    appendWhole(grown.steps, core::SeedPlacement{.label = 1, .voxels = {{0, 0, 0}, {20, 17, 19}}});
    appendWhole(grown.steps, core::SeedPlacement{.label = 2, .voxels = {{1, 0, 0}, {32, 17, 19}}});
    grown.steps.push_back(BeginGrowth{{.lowCode = 0, .highCode = 65535}});
    grown.steps.push_back(command(core::ExtendEdit{core::GrowAdvance{4}}));
    grown.steps.push_back(command(core::EndEdit{}));
    LabelTarget third{.plane = 0, .label = 3};
    third.overwritable.set(1);
    appendWhole(grown.steps, LabelSeen{.target = third, .bounds = {high}});
    appendWhole(grown.steps, core::SeedPlacement{.label = 1, .voxels = {{30, 2, 2}}});
    appendWhole(grown.steps, LabelSeen{.target = third}); // a pending seed goes too
    grown.steps.push_back(BeginGrowth{{.lowCode = 0, .highCode = 65535}});
    grown.steps.push_back(command(core::ExtendEdit{core::GrowAdvance{}}));
    grown.steps.push_back(command(core::EndEdit{}));
    for (int i = 0; i < 3; ++i)
        grown.steps.push_back(Undo{});
    cases.push_back(grown);

    EngineCase listed{"labels that are listed", codes, {}};
    appendWhole(listed.steps, LabelListed{});
    appendWhole(listed.steps, core::SeedPlacement{.label = 2, .voxels = {{0, 0, 0}, {20, 17, 19}}});
    listed.steps.push_back(BeginGrowth{{.lowCode = 0, .highCode = 65535}});
    listed.steps.push_back(command(core::ExtendEdit{core::GrowAdvance{4}}));
    listed.steps.push_back(command(core::EndEdit{}));
    LabelListed full{.plane = 0};
    for (int brick = 0; brick < core::BrickGrid{size}.brickCount(); ++brick)
        full.bricks.push_back({std::uint32_t(brick),
            std::vector<std::uint8_t>(core::BrickGrid::voxelsPerBrick, std::uint8_t(255))});
    appendWhole(listed.steps, full); // what has grown stays
    appendWhole(listed.steps, full); // nothing is left to do
    // Some are given, some freed, and of those only what may be taken.
    LabelListed some{.plane = 0, .frees = 7};
    for (const LabelListed::Brick& brick : full.bricks) {
        some.bricks.push_back(brick);
        for (std::size_t voxel = 0; voxel < some.bricks.back().labels.size(); ++voxel)
            some.bricks.back().labels[voxel] = std::uint8_t(voxel % 5 < 2 ? 7
                    : voxel % 5 == 2                                      ? 9
                                                                          : 0);
    }
    appendWhole(listed.steps, some); // nothing that is held may go
    some.overwritable.set(2);
    appendWhole(listed.steps, some);
    some.overwritable.set(0);
    some.overwritable.set(9);
    appendWhole(listed.steps, some);
    full.overwritable.set(2);
    appendWhole(listed.steps, full);
    for (int i = 0; i < 5; ++i)
        listed.steps.push_back(Undo{});
    cases.push_back(listed);
    for (int number = 0; number < 2; ++number)
        cases.push_back(planeWrites(number, size));
    for (int number = 0; number < 2; ++number)
        cases.push_back(mapWrites(number, size));

    EngineCase refused{"layer writes that are refused", codes, {}};
    refused.steps.push_back(put(noise(size, random, {0, 255}), core::Field::Coverage, 1));
    appendWhole(refused.steps, LabelCarved{{}, 1});
    appendWhole(refused.steps, LabelSeen{});
    const std::vector<std::uint8_t> whole(core::BrickGrid::voxelsPerBrick, std::uint8_t(1));
    appendWhole(refused.steps, LabelListed{.bricks = {{12, whole}}});
    appendWhole(refused.steps, LabelListed{.bricks = {{3, whole}, {3, whole}}});
    appendWhole(refused.steps, LabelListed{.bricks = {{3, {1, 2, 3}}}});
    LabelListed unsound{.bricks = {{3, whole}}};
    unsound.editable.emplace().outside = {{.plane = 1, .labels = {1}}}; // 0 is no segment
    appendWhole(refused.steps, unsound);
    const LabelListed sound{.bricks = {{3, whole}}};
    const LabelListed above{.plane = 1, .bricks = {{3, whole}}};
    appendWhole(refused.steps, core::LabelPlanes{});
    appendWhole(refused.steps, core::LabelPlanes{{sound, sound}});
    appendWhole(refused.steps, core::LabelPlanes{{above, sound}});
    appendWhole(refused.steps, core::LabelPlanes{{sound, above, sound}});
    appendWhole(refused.steps, core::LabelPlanes{{sound, unsound}});
    appendWhole(refused.steps, core::MapPlanes{});
    appendWhole(refused.steps,
        core::MapPlanes{{core::MapLabels{.plane = 1}, core::MapLabels{}, core::MapLabels{}}});
    core::MapLabels unsoundMap;
    unsoundMap.editable.emplace().outside = {{.plane = 1, .labels = {1}}}; // 0 is no segment
    appendWhole(refused.steps, core::MapPlanes{{core::MapLabels{.plane = 1}, unsoundMap}});
    appendWhole(refused.steps, CoverLabel{.layer = 1});
    appendWhole(refused.steps, FoldLayer{.layer = 1, .into = 1});
    appendWhole(
        refused.steps, LabelSeen{.target = first, .bounds = {{{0, (1 << 29) / 18 + 1, 0}, 0}}});
    refused.steps.push_back(command(core::BeginEdit{FoldLayer{.layer = 1, .into = 2}}));
    refused.steps.push_back(command(core::ExtendEdit{core::DrillPath{}}));
    refused.steps.push_back(command(core::EndEdit{}));
    cases.push_back(refused);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomWrites(number));
    return cases;
}

} // namespace test
