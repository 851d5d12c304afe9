// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/strokes/StrokeScene.h"

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/views/Bookmarks.h"
#include "tests/support/cases/strokes/RandomStrokes.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"

namespace test {

core::LoadedVolume loaded(const core::Document& document, const Codes& codes)
{
    core::LoadedVolume made{document.volumes.front(), codes.values};
    made.volume.minimum = 0.0;
    made.volume.maximum = 65535.0;
    made.volume.voxelsSha256 = "not looked at here";
    return made;
}

core::Edit segmentNamed(const char* name)
{
    core::AddSegment segment;
    segment.name = QLatin1String(name);
    segment.rgb = 0x40C080;
    return segment;
}

core::Edit bookmarkOf(const core::Edit& drill)
{
    const core::OrthographicView view = factsOfStroke(drill).view;
    core::AddBookmark bookmark;
    bookmark.name = QStringLiteral("From there");
    bookmark.view = view;
    bookmark.crosshairLps = view.targetLps;
    return bookmark;
}

StrokeScene strokeScene()
{
    Random random(31);
    const glm::ivec3 size(40, 33, 21);
    const core::Document document = randomDocument(size, random, false);
    const core::LoadedVolume volume = loaded(document, balls(size, 7, random));
    const core::Edit first = segmentNamed("First");
    const core::Edit second = segmentNamed("Second");
    const core::Edit seeds = randomSeeds(document, 1, random);
    const core::Edit others = randomSeeds(document, 2, random);
    auto drill = randomDrill(document, random).get<core::DrillStroke>();
    drill.layer = 1;
    drill.mask = {.radiusMm = drill.mask.radiusMm};
    drill.mode = core::DrillMode::Limit;
    drill.restore = false;
    drill.hidden.reset();
    const core::Edit lock =
        core::ChangeSegment{.segment = 1, .name = {}, .rgb = {}, .code = {}, .locked = true};
    const core::Edit some = growBetween(0, 700, 5);
    const core::Edit all = growBetween(0, 240);
    const core::Edit none = growBetween(60000, 60001);
    const core::Edit over =
        growBy(core::GrowCriteria{.lower = 0, .upper = 1000, .overwriteUnlocked = true});

    core::DrillStroke beside = drill;
    beside.mask.radiusMm *= 0.7;
    for (core::PenSample& sample : beside.samples)
        sample.xMm += beside.mask.radiusMm;

    const core::VolumeGeometry& geometry = document.volumes.front().geometry;
    core::PaintStroke paint{.segment = 1};
    paint.path.radiusMm = 5.0;
    paint.path.pointsLps = {geometry.toWorld({4.0, 9.0, 9.0}), geometry.toWorld({20.0, 16.0, 12.0}),
        geometry.toWorld({30.0, 30.0, 12.0})};
    paint.path.lifts = {2}; // the last point is a dab of its own
    core::PaintStroke eraser = paint;
    eraser.erase = true;
    eraser.path.radiusMm = 7.0;
    core::PaintStroke slice = paint;
    slice.path.shape = core::BrushPath::Shape::Disc;
    slice.path.normalLps = geometry.direction()[2];
    slice.seeds = true;
    slice.lower = 200;
    core::PaintStroke taker = slice;
    taker.segment = 2;
    taker.overwriteUnlocked = true;
    core::BrushStroke brush;
    brush.path = paint.path;
    core::BrushStroke back = brush;
    back.restore = true;
    back.path.radiusMm = 3.0;
    core::PeelCut peel;
    peel.view = drill.view;
    peel.polygonMm = {{-12.0, -9.0}, {11.0, -8.0}, {-9.0, 10.0}, {12.0, 11.0}};
    peel.surfaceThreshold = drill.surfaceThreshold;
    core::PeelCut peelBack = peel;
    peelBack.restore = true;
    peelBack.depthMm = 2.5;
    core::DrillStroke drillBack = drill;
    drillBack.restore = true;
    drillBack.depthMm *= 0.5;
    return {.document = document,
        .volume = volume,
        .first = first,
        .second = second,
        .seeds = seeds,
        .others = others,
        .lock = lock,
        .some = some,
        .all = all,
        .none = none,
        .over = over,
        .drill = drill,
        .beside = beside,
        .drillBack = drillBack,
        .paint = paint,
        .eraser = eraser,
        .slice = slice,
        .taker = taker,
        .brush = brush,
        .back = back,
        .peel = peel,
        .peelBack = peelBack};
}

} // namespace test
