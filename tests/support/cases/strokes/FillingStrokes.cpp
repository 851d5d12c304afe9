// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/splitting/CopySegment.h"
#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "tests/support/cases/strokes/StrokeFamilies.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"

namespace test {

namespace {

/// A disc of segment 1 on one of the acquired slices.
core::Edit discAt(const core::VolumeGeometry& geometry, const glm::dvec3& voxel, double radiusMm)
{
    return paintDiscAt(1, geometry.toWorld(voxel), geometry.direction()[2], radiusMm);
}

/// Scissors along the view of the scene's drill.
void addScissors(std::vector<StrokeCase>& cases, const StrokeScene& scene)
{
    const core::LoadedVolume& volume = scene.volume;
    const core::Edit& first = scene.first;
    const core::Edit& second = scene.second;
    const core::SegmentScissors fill{.segment = 1,
        .view = factsOfStroke(scene.drill).view,
        .polygonMm = {{-9.0, -8.0}, {10.0, -6.0}, {2.0, 11.0}}};
    cases.push_back({"scissors that fill", volume, {first}, fill});
    core::SegmentScissors deep = fill;
    deep.segment = 2;
    deep.depthMm = 6.0;
    deep.overwriteUnlocked = true;
    cases.push_back(
        {"scissors that fill to a depth over another", volume, {first, second, fill}, deep});
    cases.push_back({"scissors beside a locked segment", volume,
        {first, second, scene.paint, scene.lock}, deep});
    core::SegmentScissors values = fill;
    values.outside = true;
    values.lower = 300.0;
    values.upper = 900.0;
    cases.push_back({"scissors that fill outside, of some values", volume, {first}, values});
    core::SegmentScissors erase = fill;
    erase.erase = true;
    cases.push_back({"scissors that erase", volume, {first, scene.paint}, erase});
    cases.push_back({"scissors that erase after growth", volume,
        {first, scene.seeds, scene.some, scene.paint}, erase});
    core::SegmentScissors both = erase;
    both.outside = true;
    both.others = std::vector<int>{2};
    cases.push_back(
        {"scissors that keep what is inside", volume, {first, second, values, deep}, both});
    core::SegmentScissors shallow = erase;
    shallow.depthMm = 3.0;
    cases.push_back({"scissors that erase what is seen", volume, {first, fill}, shallow});
    cases.push_back(
        {"growth after scissors", volume, {first, scene.paint, erase, scene.seeds}, scene.all});
    cases.push_back({"undo only scissors", volume, {first, scene.paint, shallow, scene.drill},
        revertRows({3})});
}

/// Into segments by islands, of which these discs are three, and by planes.
void addSplits(
    std::vector<StrokeCase>& cases, const StrokeScene& scene, const std::vector<core::Edit>& discs)
{
    const core::LoadedVolume& volume = scene.volume;
    const core::VolumeGeometry& geometry = volume.volume.geometry;
    const auto after = [&](std::vector<core::Edit> edits) {
        std::vector<core::Edit> all{scene.first};
        all.insert(all.end(), discs.begin(), discs.end());
        all.insert(all.end(), edits.begin(), edits.end());
        return all;
    };
    const core::SplitIslands islands{.segment = 1};
    core::SplitIslands named = islands;
    named.into = std::vector{core::SplitPart{.name = QStringLiteral("Apart"), .rgb = 0x40C0C0}};
    core::SplitIslands large = islands;
    large.mm3 = 1.5 * geometry.voxelVolumeMm3();
    core::SplitIslands within = islands;
    within.editable = core::EditableRange{.box = core::GrowBox{geometry.toWorld({0.0, 0.0, 0.0}),
                                              geometry.toWorld({16.0, 99.0, 99.0})}};
    cases.push_back({"split islands within limits", volume, after({}), within});
    cases.push_back({"split islands into segments", volume, after({}), islands});
    cases.push_back({"split one island off", volume, after({}), named});
    cases.push_back({"split islands from a size on", volume, after({scene.second}), large});
    cases.push_back({"split islands one after another", volume, after({named}), islands});
    cases.push_back(
        {"growth after islands were split", volume, after({islands, scene.seeds}), scene.all});

    const glm::dmat3 axes = geometry.direction();
    const core::SplitSegment across{.segment = 1,
        .placeLps = geometry.toWorld({16.0, 13.0, 6.5}),
        .normalLps = axes[2],
        .into = {.name = QStringLiteral("Above"), .rgb = 0xC040C0}};
    core::SplitSegment oblique = across;
    oblique.placeLps = geometry.toWorld({14.3, 12.2, 10.4});
    oblique.normalLps = -3.0 * axes[0] - 0.7 * axes[1] + 0.2 * axes[2];
    cases.push_back({"split a segment between slices", volume, after({}), across});
    cases.push_back({"split a segment by a plane", volume, {scene.first, scene.paint}, oblique});
    cases.push_back({"split what has grown, too, by a plane", volume,
        {scene.first, scene.seeds, scene.some, scene.paint}, oblique});
    cases.push_back({"growth after a split by a plane", volume,
        {scene.first, scene.paint, oblique, scene.seeds}, scene.all});
    core::SplitSegment limited = oblique;
    limited.editable = core::EditableRange{.outside = std::vector<int>{2}};
    cases.push_back({"split a segment within the editable range", volume,
        {scene.first, scene.second, scene.paint}, limited});

    core::SplitByCurve inside{.segment = 1,
        .view = factsOfStroke(scene.drill).view,
        .curveMm = {{-9.0, -8.0}, {3.0, -6.0}, {2.0, 11.0}},
        .into = {.name = QStringLiteral("Inside"), .rgb = 0x40C040}};
    core::SplitByCurve deep = inside;
    deep.depthMm = 4.0;
    core::SplitByCurve line = inside;
    line.open = true;
    line.curveMm = {{-2.0, -4.0}, {1.0, 0.5}, {0.5, 3.0}};
    line.side = core::SplitByCurve::Side::Smaller;
    cases.push_back({"split a segment by a curve", volume, {scene.first, scene.paint}, inside});
    cases.push_back(
        {"split a segment by a curve to a depth", volume, {scene.first, scene.paint}, deep});
    cases.push_back({"split what has grown, too, along a line", volume,
        {scene.first, scene.seeds, scene.some, scene.paint}, line});
    cases.push_back({"growth after a split along a line", volume,
        {scene.first, scene.paint, line, scene.seeds}, scene.all});
    line.side = core::SplitByCurve::Side::Larger;
    line.editable = limited.editable;
    cases.push_back({"split along a line within the editable range", volume,
        {scene.first, scene.second, scene.paint}, line});
}

/// Into further label planes.
void addCopies(std::vector<StrokeCase>& cases, const StrokeScene& scene)
{
    const core::LoadedVolume& volume = scene.volume;
    const core::CopySegment copy{.segment = 1, .name = QStringLiteral("Again"), .rgb = 0x40C0C0};
    core::CopySegment named = copy;
    named.plane = 3;
    core::CopySegment limited = copy;
    limited.editable = core::EditableRange{.lower = 100.0};
    const core::AddSegment above{
        .name = QStringLiteral("Above"), .rgb = 0xC0C040, .code = {}, .plane = 1};
    const core::Edit dab = paintAt(2, {volume.volume.geometry.toWorld({16.0, 13.0, 6.0})});
    cases.push_back({"copy a segment", volume, {scene.first, scene.paint}, copy});
    cases.push_back({"copy a segment into a plane", volume, {scene.first, scene.paint}, named});
    cases.push_back(
        {"copy a segment within the editable range", volume, {scene.first, scene.paint}, limited});
    cases.push_back({"copy a copy beside another", volume,
        {scene.first, scene.paint, copy, core::RemoveSegment{.segment = 1}},
        core::CopySegment{.segment = 2, .name = QStringLiteral("Back"), .rgb = 7}});
    cases.push_back({"growth after a copy", volume,
        {scene.first, scene.seeds, scene.some, scene.paint, copy}, scene.all});
    cases.push_back({"paint a copy", volume, {scene.first, scene.paint, copy}, dab});
    cases.push_back(
        {"paint a segment over another", volume, {scene.first, scene.paint, above}, dab});
}

} // namespace

void addFillingStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene)
{
    const core::LoadedVolume& volume = scene.volume;
    const core::VolumeGeometry& geometry = volume.volume.geometry;
    const core::Edit& first = scene.first;
    const core::Edit& second = scene.second;
    const core::Edit low = discAt(geometry, {14.0, 12.0, 4.0}, 6.0);
    const core::Edit high = discAt(geometry, {18.0, 15.0, 9.0}, 3.0);
    const core::Edit apart = discAt(geometry, {33.0, 26.0, 15.0}, 4.0);
    const core::FillBetweenSlices between{.segment = 1};
    const core::FillBetweenSlices acquired{.segment = 1, .axis = core::SliceAxis::K};
    cases.push_back({"fill between slices", volume, {first, low, high}, between});
    cases.push_back(
        {"fill between slices that do not overlap", volume, {first, low, high, apart}, acquired});
    cases.push_back({"fill between slices beside another", volume,
        {first, second, scene.others, scene.some, low, high}, acquired});
    const glm::dvec3 upright = geometry.toWorld({16.0, 13.0, 6.0});
    const core::Edit coronal = test::paintDiscAt(1, upright, geometry.direction()[1], 4.0);
    const core::Edit oblique = test::paintDiscAt(1, upright, {1.0, 0.5, 0.4}, 4.0);
    const core::FillBetweenSlices planes{.segment = 1,
        .planes = std::vector<core::DrawnPlane>{
            {geometry.toWorld({14.0, 12.0, 4.0}), geometry.direction()[2]},
            {geometry.toWorld({14.0, 12.0, 9.0}), geometry.direction()[2]},
            {upright, geometry.direction()[1]}, {upright, {1.0, 0.5, 0.4}}}};
    cases.push_back({"fill between planes of several directions", volume,
        {first, low, high, coronal, oblique}, planes});
    cases.push_back({"fill between slices of a solid segment", volume, {first, low}, between});
    cases.push_back({"fill between slices of an empty segment", volume, {first}, between});
    cases.push_back({"growth after filling between slices", volume,
        {first, low, high, between, scene.seeds}, scene.all});
    cases.push_back({"undo only a fill between slices", volume,
        {first, low, high, between, scene.drill}, revertRows({4})});

    const core::MirrorSegment middle{.segment = 1};
    const core::MirrorSegment aside{.segment = 1,
        .sides = core::MirroredSides::AnteriorPosterior,
        .placeLps = geometry.toWorld({14.0, 15.4, 4.0}),
        .keep = true};
    cases.push_back({"mirror a segment", volume, {first, low, high}, middle});
    cases.push_back({"mirror a segment beside another", volume,
        {first, second, scene.others, scene.some, low, high}, aside});
    cases.push_back({"mirror an empty segment", volume, {first}, middle});
    cases.push_back(
        {"growth after mirroring", volume, {first, low, aside, scene.seeds}, scene.all});
    cases.push_back(
        {"undo only a mirroring", volume, {first, low, aside, scene.drill}, revertRows({3})});

    core::FloodFill flood{.segment = 1,
        .placeLps = geometry.toWorld({20.0, 16.0, 10.0}),
        .within = core::SliceAxis::K,
        .tolerance = 150.0};
    cases.push_back({"flood fill in a slice", volume, {first}, flood});
    flood.within = core::SliceAxis::I;
    flood.corners = true;
    cases.push_back({"flood fill across rows, over corners", volume, {first}, flood});
    flood.within.reset();
    core::FloodFill tilted = flood;
    const glm::dmat3 along = geometry.direction();
    tilted.normalLps = 3.0 * along[0] - 2.0 * along[1] + 4.0 * along[2];
    cases.push_back({"flood fill in an oblique slice, over corners", volume, {first}, tilted});
    tilted.corners = false;
    cases.push_back({"flood fill in an oblique slice", volume, {first, low}, tilted});
    cases.push_back({"undo only a flood fill in an oblique slice", volume,
        {first, scene.paint, tilted, scene.drill}, revertRows({3})});
    cases.push_back({"flood fill in all directions", volume, {first, low}, flood});
    core::FloodFill over = flood;
    over.segment = 2;
    over.overwriteUnlocked = true;
    cases.push_back({"flood fill over another segment", volume, {first, second, flood}, over});
    cases.push_back({"flood fill beside a locked segment", volume,
        {first, second, scene.paint, scene.lock}, over});
    const core::FloodFill away{
        .segment = 1, .placeLps = geometry.toWorld({14.0, 12.0, 4.0}), .erase = true};
    cases.push_back({"take a region away", volume, {first, low, high}, away});
    cases.push_back(
        {"take a region away after growth", volume, {first, scene.seeds, scene.some, low}, away});
    cases.push_back({"growth after a flood fill", volume, {first, flood, scene.seeds}, scene.all});
    cases.push_back({"undo only a flood fill", volume, {first, scene.paint, flood, scene.drill},
        revertRows({3})});
    addScissors(cases, scene);
    addSplits(cases, scene, {low, high, apart});
    addCopies(cases, scene);

    // Every value counts as within, so that it grows for certain, wherever it is.
    core::EvolveContour contour{.segment = 1,
        .upper = 1200.0,
        .softness = 50.0,
        .smoothness = 20,
        .bubbleLps = geometry.toWorld({20.0, 16.0, 10.0}),
        .bubbleMm = 4.1,
        .generations = 4};
    cases.push_back({"a contour from a bubble", volume, {first}, contour});
    cases.push_back(
        {"undo only a contour", volume, {first, contour, scene.drill}, revertRows({2})});
    cases.push_back({"growth after a contour", volume, {first, contour, scene.seeds}, scene.all});
    core::EvolveContour further = contour;
    further.bubbleLps.reset();
    further.bubbleMm = 0.0;
    further.edge = 80;
    further.edgeGradient = 100.0;
    cases.push_back({"a contour further, kept at edges", volume, {first, contour}, further});
    core::EvolveContour back = further;
    back.upper = 100.0; // the noise goes beyond it
    cases.push_back({"a contour that withdraws", volume, {first, contour, further}, back});
    cases.push_back({"a contour of an empty segment", volume, {first}, further});
    core::EvolveContour round = contour;
    round.round = true;
    cases.push_back({"a round contour from a bubble", volume, {first}, round});
    core::EvolveContour several = round;
    several.furtherBubblesLps = {
        geometry.toWorld({8.0, 12.0, 16.0}), geometry.toWorld({24.0, 18.0, 10.0})};
    cases.push_back({"a contour from three bubbles", volume, {first}, several});
    core::EvolveContour erasing = round;
    erasing.erase = true;
    erasing.bubbleMm = 2.1;
    erasing.generations = 2;
    cases.push_back({"a contour that erases from a bubble", volume, {first, contour}, erasing});
    erasing.furtherBubblesLps = {geometry.toWorld({22.0, 16.0, 10.0})};
    cases.push_back({"a contour that erases from two bubbles", volume, {first, several}, erasing});
    core::EvolveContour eroding = further;
    eroding.erase = true;
    eroding.generations = 2;
    cases.push_back({"a contour that erases from outside", volume, {first, contour}, eroding});
    core::EvolveContour taking = contour;
    taking.segment = 2;
    taking.overwriteUnlocked = true;
    cases.push_back({"a contour over another segment", volume, {first, second, low}, taking});
    cases.push_back({"a contour beside a locked segment", volume,
        {first, second, scene.paint, scene.lock}, taking});
}

} // namespace test
