// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "tests/support/cases/strokes/StrokeFamilies.h"
#include "tests/support/scenes/PlainEdits.h"

namespace test {

void addPaintStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene)
{
    const core::LoadedVolume& volume = scene.volume;
    const core::Edit& first = scene.first;
    const core::Edit& second = scene.second;
    const core::Edit& seeds = scene.seeds;
    const core::Edit& others = scene.others;
    const core::Edit& lock = scene.lock;
    const core::Edit& some = scene.some;
    const core::Edit& all = scene.all;
    const core::Edit& drill = scene.drill;
    const core::Edit& paint = scene.paint;
    const core::Edit& eraser = scene.eraser;
    const core::Edit& slice = scene.slice;
    const core::Edit& taker = scene.taker;
    const core::VolumeGeometry& geometry = scene.document.volumes.front().geometry;

    cases.push_back({"paint", volume, {first}, paint});
    cases.push_back({"paint on a slice", volume, {first, paint}, slice});
    cases.push_back({"paint over another", volume, {first, second, seeds, all, paint}, taker});
    cases.push_back({"erase what has grown", volume, {first, seeds, all, paint}, eraser});
    cases.push_back({"erase nothing", volume, {first}, eraser});
    cases.push_back({"growth from paint", volume, {first, slice}, all});
    cases.push_back({"growth after erasing", volume, {first, seeds, some, eraser}, all});
    cases.push_back({"undo only paint", volume, {first, paint, drill}, revertRows({2})});
    core::FillOutline outline{.segment = 1,
        .originLps = geometry.toWorld({20.0, 16.0, 12.0}),
        .rightLps = geometry.direction()[0],
        .upLps = geometry.direction()[1],
        .polygonMm = {{-12.0, -9.0}, {11.0, -8.0}, {-9.0, 10.0}, {12.0, 11.0}}};
    core::FillOutline leaning = outline;
    leaning.segment = 2;
    leaning.upLps = geometry.direction()[1] + 0.7 * geometry.direction()[2];
    leaning.overwriteUnlocked = true;
    leaning.lower = 200;
    core::FillOutline erased = leaning;
    erased.segment = 1;
    erased.erase = true;
    erased.lower.reset();
    cases.push_back({"fill an outline", volume, {first}, outline});
    cases.push_back(
        {"fill an outline over another", volume, {first, second, seeds, all, outline}, leaning});
    cases.push_back({"fill an outline beside a locked one", volume,
        {first, second, paint, outline, lock}, leaning});
    cases.push_back({"erase an outline in what has grown", volume, {first, seeds, all}, erased});
    cases.push_back({"growth after an erased outline", volume, {first, seeds, some, erased}, all});
    cases.push_back({"undo only an outline", volume, {first, outline, drill}, revertRows({2})});
    auto pressed = paint.get<core::PaintStroke>();
    pressed.path.pressures = std::vector<double>{0.2, 1.0, 0.6};
    cases.push_back({"paint as the pen is pressed", volume, {first}, pressed});
    pressed = slice.get<core::PaintStroke>();
    pressed.path.pressures = std::vector<double>{1.0, 0.0, 0.8};
    cases.push_back({"paint on a slice as the pen is pressed", volume, {first, paint}, pressed});
    pressed.path.shape = core::BrushPath::Shape::Square;
    pressed.path.sideLps = geometry.direction()[0] + 0.5 * geometry.direction()[1];
    cases.push_back({"paint a square on a slice", volume, {first, paint}, pressed});
    auto cube = eraser.get<core::PaintStroke>();
    cube.path.shape = core::BrushPath::Shape::Cube;
    cube.path.normalLps = geometry.direction()[2];
    cube.path.sideLps = geometry.direction()[0];
    cases.push_back({"erase a cube", volume, {first, seeds, some, paint}, cube});
    auto edgewise = paint.get<core::PaintStroke>();
    edgewise.edgeTolerance = 250.0;
    cases.push_back({"paint along edges", volume, {first, seeds}, edgewise});
    edgewise.path.pressures = std::vector<double>{0.2, 1.0, 0.6};
    edgewise.toleranceByPressure = true;
    cases.push_back({"paint along edges as the pen is pressed", volume, {first, seeds}, edgewise});
    edgewise.path.pressures.reset();
    edgewise.toleranceByPressure.reset();
    auto noEdges = slice.get<core::PaintStroke>();
    noEdges.edgeTolerance = 65535.0;
    noEdges.path.pressures = std::vector<double>{1.0, 0.4, 0.8};
    cases.push_back({"paint on a slice that has no edge", volume, {first}, noEdges});
    cube.edgeTolerance = 180.0;
    cases.push_back(
        {"erase along edges what has grown", volume, {first, seeds, some, paint}, cube});
    cases.push_back({"growth from paint along edges", volume, {first, noEdges}, all});
    cases.push_back(
        {"undo only paint along edges", volume, {first, edgewise, drill}, revertRows({2})});
    auto nudge = slice.get<core::PaintStroke>();
    nudge.tool = core::PaintStroke::Tool::Nudge;
    cases.push_back({"nudge the border outwards", volume, {first, seeds, some, paint}, nudge});
    core::PaintStroke pressedNudge = nudge;
    pressedNudge.path.pressures = std::vector<double>(nudge.path.pointsLps.size(), 0.4);
    pressedNudge.path.pressures->back() = 1.0;
    cases.push_back(
        {"nudge the border, pressed harder", volume, {first, seeds, some, paint}, pressedNudge});
    nudge.erase = true;
    nudge.seeds = false;
    cases.push_back({"nudge the border inwards", volume, {first, seeds, some, paint}, nudge});
    auto dab = paint.get<core::PaintStroke>();
    dab.segment = 2;
    dab.path.radiusMm = 2.0;
    dab.path.lifts.clear();
    dab.path.pointsLps = {geometry.toWorld({34.0, 4.0, 4.0})};
    core::GrowFromSeeds fromSeeds;
    core::GrowFromSeeds within;
    within.box =
        core::GrowBox{geometry.toWorld({3.0, 2.0, 5.0}), geometry.toWorld({90.0, 30.0, 12.0})};
    within.connectivity = 26;
    within.lengthCost = 0.5;
    core::GrowFromSeeds between;
    between.segments = {2, 3};
    between.overwriteUnlocked = true;
    const core::Edit third = segmentNamed("Third");
    core::PaintStroke last = dab;
    last.segment = 3;
    last.path.pointsLps = {geometry.toWorld({5.0, 28.0, 17.0})};
    cases.push_back({"growing from seeds", volume, {first, second, paint, dab}, fromSeeds});
    cases.push_back({"growing from seeds that are sketched", volume, {first, second, seeds, others},
        fromSeeds});
    cases.push_back({"growing from seeds over what has grown", volume,
        {first, second, third, seeds, some, dab, last}, between});
    cases.push_back({"growing from seeds in a box, beside a locked one", volume,
        {first, second, third, paint, dab, last, lock}, within});
    cases.push_back({"growing from seeds again", volume,
        {first, second, paint, dab, fromSeeds, eraser}, fromSeeds});
    cases.push_back({"undo only growing from seeds", volume,
        {first, second, paint, dab, fromSeeds, drill}, revertRows({5})});
    cases.push_back(
        {"growth after growing from seeds", volume, {first, second, seeds, dab, fromSeeds}, all});
}

} // namespace test
