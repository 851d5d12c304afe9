// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/layers/MergeLayers.h"
#include "core/edits/kinds/layers/MoveLayer.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/edits/kinds/parts/SegmentChoice.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/pieces/PastePiece.h"
#include "core/edits/kinds/pieces/RemovePiece.h"
#include "core/edits/kinds/pieces/SendPiecesHome.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/segments/SegmentSeen.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/edits/kinds/views/Bookmarks.h"
#include "core/edits/kinds/views/Measurements.h"
#include "tests/support/cases/strokes/StrokeFamilies.h"
#include "tests/support/scenes/CutEdits.h"

#include "core/brick/VoxelRuns.h"
#include "tests/support/scenes/PlainEdits.h"

namespace test {

namespace {

/// Two segments that overlap, as if read from a file.
core::ImportMask importOf(const glm::ivec3& size)
{
    core::VoxelRuns low;
    core::VoxelRuns middle;
    const std::uint64_t slice = std::uint64_t(size.x) * std::uint64_t(size.y);
    for (int row = 3; row < size.y - 2; ++row) {
        const std::uint64_t at = slice * 2 + std::uint64_t(row) * std::uint64_t(size.x);
        low.append(at + 1, std::uint64_t(size.x) / 2);
        middle.append(at + std::uint64_t(row), 5);
    }
    middle.append(slice * std::uint64_t(size.z / 2), slice * 2);
    core::ImportMask mask{.file = QStringLiteral("organs.seg.nrrd")};
    mask.size = size;
    mask.segments = {{.name = QStringLiteral("Low"),
                         .rgb = 0x40C080,
                         .code = {},
                         .voxels = core::packedRuns(low)},
        {.name = QStringLiteral("Middle"),
            .rgb = 0xC04080,
            .code = {.scheme = QStringLiteral("SCT"),
                .value = QStringLiteral("10200004"),
                .meaning = QStringLiteral("Liver")},
            .voxels = core::packedRuns(middle)}};
    return mask;
}

/// The same, all of it into segment 1.
core::ImportMask joinedFirst(core::ImportMask mask)
{
    mask.as = core::SegmentWord{.number = 1, .name = {}};
    return mask;
}

} // namespace

void addDocumentStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene)
{
    const core::LoadedVolume& volume = scene.volume;
    const core::Edit& first = scene.first;
    const core::Edit& second = scene.second;
    const core::Edit& seeds = scene.seeds;
    const core::Edit& others = scene.others;
    const core::Edit& lock = scene.lock;
    const core::Edit& some = scene.some;
    const core::Edit& all = scene.all;
    const core::Edit& over = scene.over;
    const core::Edit& drill = scene.drill;
    const core::Edit& beside = scene.beside;
    const core::Edit& drillBack = scene.drillBack;
    const core::Edit& paint = scene.paint;
    const core::Edit& taker = scene.taker;
    const core::Edit& brush = scene.brush;
    const core::Edit& peel = scene.peel;
    const core::VolumeGeometry& geometry = scene.document.volumes.front().geometry;

    const core::Edit other = drillWith({.layer = 2}, drill);
    const core::Edit layer = core::AddLayer{.name = QStringLiteral("Other")};
    const core::Edit mute = core::ChangeLayer{.layer = 1, .muted = true};
    const core::Edit bookmark = bookmarkOf(drill);
    cases.push_back(
        {"delete an empty segment", volume, {first, second}, core::RemoveSegment{.segment = 1}});
    cases.push_back({"delete a segment and its seeds", volume, {first, seeds, second, others},
        core::RemoveSegment{.segment = 1}});
    cases.push_back({"delete one of two grown", volume, {first, seeds, second, others, some, all},
        core::RemoveSegment{.segment = 2}});
    cases.push_back({"growth after a deletion", volume,
        {first, seeds, second, others, some, core::RemoveSegment{.segment = 1}}, all});
    cases.push_back({"add after a deletion", volume,
        {first, second, core::RemoveSegment{.segment = 2}}, first});
    cases.push_back({"add a layer", volume, {drill}, layer});
    cases.push_back({"move a layer", volume, {layer}, core::MoveLayer{.layer = 2, .place = 1}});
    cases.push_back({"mute a layer", volume, {layer, drill, other}, mute});
    cases.push_back({"drill over another layer", volume, {layer, drill}, other});
    cases.push_back({"drill through a muted layer", volume, {layer, drill, mute}, other});
    cases.push_back({"drill where a layer is heard again", volume,
        {layer, drill, mute, core::ChangeLayer{.layer = 1, .muted = false}}, other});
    cases.push_back({"bookmark", volume, {drill}, bookmark});

    const core::SegmentChoice toFirst{.segment = 1};
    const core::SegmentChoice toNew{.name = QStringLiteral("Carved"), .rgb = 0x4080C0};
    const core::LayerToSegment carved{.layer = 1, .target = toNew};
    const core::SegmentToLayer cover{.segment = 1, .layer = 2};
    core::SegmentSeen seen{.target = toNew, .lower = 300.0};
    core::SegmentSeen clipped{.target = toFirst, .overwriteUnlocked = true};
    clipped.hidden = {{beyond(geometry.toWorld({20.0, 16.0, 10.0}), {0.3, -0.2, 1.0}),
        beyond(geometry.toWorld({12.0, 16.0, 10.0}), geometry.direction()[0])}};
    const core::MergeLayers merge{.from = 1, .into = 2};
    const core::RemoveLayer removeLayer{.layer = 2};
    cases.push_back({"layer to a new segment", volume, {drill}, carved});
    cases.push_back({"layer to a segment", volume, {first, seeds, all, second, peel},
        core::LayerToSegment{.layer = 1, .target = {.segment = 2}, .overwriteUnlocked = true}});
    cases.push_back({"nothing to a new segment", volume, {layer}, carved});
    cases.push_back({"muted layer to a segment", volume, {layer, drill, mute}, carved});
    cases.push_back({"segment to layer", volume, {first, seeds, some, layer, drill, other}, cover});
    cases.push_back({"empty segment to layer", volume, {first, layer}, cover});
    const core::SegmentToLayer allBut{.segment = 1, .layer = 2, .outside = true};
    cases.push_back(
        {"all but a segment to layer", volume, {first, seeds, some, layer, drill, other}, allBut});
    cases.push_back({"segment what is seen", volume, {first, paint, drill}, seen});
    cases.push_back(
        {"segment what is seen in a clip region", volume, {first, second, taker, peel}, clipped});
    cases.push_back(
        {"nothing is seen", volume, {}, core::SegmentSeen{.target = toNew, .lower = 1e9}});
    const core::ImportMask mask = importOf(geometry.size);
    core::ImportMask joined = mask;
    joined.as = core::SegmentWord{.number = 2, .name = {}};
    joined.overwriteUnlocked = true;
    cases.push_back({"import a mask", volume, {}, mask});
    core::ImportMask turned = mask;
    turned.ahead = std::vector<int>{2, 1};
    cases.push_back({"import a mask, its second segment before its first", volume, {}, turned});
    cases.push_back({"import a mask around what has grown", volume, {first, seeds, some}, mask});
    cases.push_back({"import a mask into a segment", volume, {first, seeds, all, second}, joined});
    cases.push_back({"growth after a mask", volume, {first, seeds, some, joinedFirst(mask)}, all});
    core::ImportMask taking = mask;
    taking.overwriteUnlocked = true;
    cases.push_back({"import a mask twice", volume, {mask}, taking});
    cases.push_back({"a mask that is held already", volume, {mask}, mask});
    // Its segments keep what they share, in two planes.
    core::ImportMask apart = mask;
    apart.planes = std::vector<int>{0, 1};
    core::ImportMask apartTaking = apart;
    apartTaking.planes = std::vector<int>{2, 0};
    apartTaking.overwriteUnlocked = true;
    cases.push_back({"import a mask that overlaps", volume, {}, apart});
    cases.push_back(
        {"import a mask that overlaps around what has grown", volume, {first, seeds, some}, apart});
    cases.push_back({"import over two planes", volume, {apart}, apartTaking});
    cases.push_back({"import into one of two planes", volume, {apart}, joined});
    cases.push_back({"invert a segment of a further plane", volume, {apart},
        core::InvertSegment{.segment = 2}});
    cases.push_back({"delete a segment of a further plane", volume, {apart},
        core::RemoveSegment{.segment = 2}});
    cases.push_back({"paint under a segment of a further plane", volume, {apart}, paint});
    core::Edit upper = paint;
    upper.as<core::PaintStroke>()->segment = 2;
    core::Edit upperAway = upper;
    upperAway.as<core::PaintStroke>()->erase = true;
    cases.push_back({"paint in a further plane", volume, {apart, paint}, upper});
    cases.push_back({"erase in a further plane", volume, {apart, paint, upper}, upperAway});
    cases.push_back({"undo only what was painted in one of two planes", volume,
        {apart, paint, upper}, revertRows({2})});
    core::SegmentSeen seenUpper{.target = {.segment = 2}, .lower = 300.0};
    cases.push_back({"segment what is seen in a further plane", volume, {apart, paint}, seenUpper});
    cases.push_back(
        {"undo only a mask", volume, {first, joinedFirst(mask), drill}, revertRows({2})});
    cases.push_back({"growth after what is seen", volume, {first, seeds, some, seen}, over});
    const core::InvertSegment invert{.segment = 1};
    cases.push_back({"invert an empty segment", volume, {first}, invert});
    cases.push_back({"invert a segment twice", volume, {first, paint, invert}, invert});
    cases.push_back({"invert what has grown, beside another", volume,
        {first, seeds, second, others, some, drill}, invert});
    cases.push_back({"invert a segment while another is locked", volume,
        {first, seeds, second, others, some, lock}, core::InvertSegment{.segment = 2}});
    cases.push_back(
        {"growth after an inversion", volume, {first, seeds, second, others, some, invert}, all});
    cases.push_back(
        {"undo only an inversion", volume, {first, paint, invert, drill}, revertRows({3})});
    using core::CleanSegment;
    using core::IslandRule;
    const CleanSegment fill{.segment = 1};
    const CleanSegment largest{.segment = 1, .rule = IslandRule::KeepLargest};
    const CleanSegment specks{.segment = 1, .rule = IslandRule::RemoveSmall, .mm3 = 1e6};
    cases.push_back({"fill holes of what has grown", volume, {first, seeds, all}, fill});
    cases.push_back({"fill holes where there are none", volume, {first}, fill});
    cases.push_back({"keep the largest island", volume, {first, paint}, largest});
    cases.push_back({"remove all islands", volume, {first, paint}, specks});
    cases.push_back(
        {"undo only what was cleaned", volume, {first, paint, specks, drill}, revertRows({3})});
    CleanSegment clicked{.segment = 1, .rule = IslandRule::KeepClicked};
    clicked.islandLps = geometry.toWorld({20.0, 16.0, 12.0});
    cases.push_back({"keep only a clicked island", volume, {first, paint}, clicked});
    clicked.rule = IslandRule::RemoveClicked;
    cases.push_back({"remove a clicked island", volume, {first, paint}, clicked});
    clicked.rule = IslandRule::GiveClicked;
    clicked.to = 2;
    cases.push_back({"give a clicked island away", volume, {first, second, paint}, clicked});
    cases.push_back({"growth after an island was given away", volume,
        {first, second, paint, clicked, seeds}, all});
    cases.push_back({"undo only an island that was given away", volume,
        {first, second, paint, clicked, drill}, revertRows({4})});
    const core::CombineSegments mergeSegments{.segment = 2, .with = 1};
    const core::CombineSegments swap{
        .segment = 1, .with = 2, .how = core::CombineSegments::How::Swap};
    cases.push_back({"merge a segment into another", volume, {first, seeds, second, others, some},
        mergeSegments});
    cases.push_back(
        {"merge an empty segment into another", volume, {first, second}, mergeSegments});
    cases.push_back({"merge a segment of another label plane", volume, {apart}, mergeSegments});
    cases.push_back({"growth after a merge of two label planes", volume,
        {apart, seeds, some, core::CombineSegments{.segment = 1, .with = 2}}, all});
    cases.push_back({"undo only a merge of two label planes", volume,
        {apart, paint, mergeSegments, drill}, revertRows({3})});
    cases.push_back(
        {"swap two that have grown", volume, {first, seeds, second, others, some}, swap});
    cases.push_back({"growth after a merge of segments", volume,
        {first, seeds, second, others, some, mergeSegments}, all});
    cases.push_back({"growth after a swap of segments", volume,
        {first, seeds, second, others, some, swap}, all});
    cases.push_back({"undo only a merge of segments", volume,
        {first, paint, second, mergeSegments, drill}, revertRows({4})});
    using core::ReshapeSegment;
    using core::ShapeOperation;
    const ReshapeSegment margin{.segment = 1, .operation = ShapeOperation::Grow, .mm = 6.0};
    const ReshapeSegment less{.segment = 1, .operation = ShapeOperation::Shrink, .mm = 3.0};
    const ReshapeSegment shell{.segment = 1, .operation = ShapeOperation::Hollow, .mm = 2.5};
    const ReshapeSegment around{.segment = 1,
        .operation = ShapeOperation::Hollow,
        .mm = 6.0,
        .shell = core::ShellPlace::Outside};
    const ReshapeSegment open{.segment = 1, .operation = ShapeOperation::Open, .mm = 30.0};
    const ReshapeSegment close{.segment = 1, .operation = ShapeOperation::Close, .mm = 6.0};
    const ReshapeSegment median{.segment = 1, .operation = ShapeOperation::Median, .mm = 6.0};
    const ReshapeSegment gaussian{.segment = 1, .operation = ShapeOperation::Gaussian, .mm = 4.0};
    const ReshapeSegment sided{.segment = 1,
        .operation = ShapeOperation::Grow,
        .mm = 6.0,
        .sides = {.leftMm = 0.0, .posteriorMm = 2.0, .superiorMm = 9.0}};
    cases.push_back({"grow by margins that differ", volume, {first, paint}, sided});
    cases.push_back({"grow by a margin", volume, {first, paint}, margin});
    cases.push_back(
        {"grow by a margin beside another", volume, {first, second, paint, others, some}, margin});
    cases.push_back({"shrink by a margin", volume, {first, paint}, less});
    cases.push_back({"hollow a segment", volume, {first, paint}, shell});
    cases.push_back({"a shell around a segment", volume, {first, paint}, around});
    cases.push_back({"open a segment", volume, {first, paint}, open});
    cases.push_back({"close a hollow segment", volume, {first, paint, shell}, close});
    const ReshapeSegment wrap{.segment = 1, .operation = ShapeOperation::Wrap, .mm = 3.0};
    cases.push_back({"wrap a hollow segment", volume, {first, paint, shell}, wrap});
    cases.push_back({"close an empty segment", volume, {first}, close});
    cases.push_back({"smooth a segment", volume, {first, paint}, median});
    cases.push_back({"smooth a segment by a Gaussian", volume, {first, paint}, gaussian});
    ReshapeSegment joint = gaussian;
    joint.with = std::vector<int>{2};
    cases.push_back(
        {"smooth two segments together", volume, {first, second, paint, others}, joint});
    cases.push_back({"growth after two were smoothed together", volume,
        {first, seeds, second, others, some, joint}, all});
    cases.push_back({"growth after a margin", volume, {first, paint, less, seeds}, all});
    cases.push_back({"undo only a margin", volume, {first, paint, margin, drill}, revertRows({3})});
    // Tissue is between 750 and 1000, noise below 250.
    using core::ThresholdSegment;
    const ThresholdSegment tissue{.segment = 1, .lower = 700.0};
    const ThresholdSegment more{.segment = 1,
        .lower = 100.0,
        .upper = 900.0,
        .mode = ThresholdSegment::Mode::Add,
        .overwriteUnlocked = true};
    const ThresholdSegment fewer{
        .segment = 1, .upper = 900.0, .mode = ThresholdSegment::Mode::Subtract};
    const ThresholdSegment within{.segment = 1,
        .lower = 100.0,
        .onlyVisible = true,
        .box =
            core::GrowBox{geometry.toWorld({8.0, 8.0, 4.0}), geometry.toWorld({30.0, 25.0, 15.0})}};
    cases.push_back({"a threshold for an empty segment", volume, {first}, tissue});
    cases.push_back({"a threshold in place of what has grown", volume,
        {first, seeds, second, others, some, drill}, tissue});
    ThresholdSegment moved = more; // what tissue has beyond goes, noise comes
    moved.mode = ThresholdSegment::Mode::Replace;
    cases.push_back(
        {"an interval that is moved", volume, {first, seeds, second, others, some, tissue}, moved});
    cases.push_back({"add a threshold over another segment", volume,
        {first, seeds, second, others, some}, more});
    cases.push_back({"subtract a threshold", volume, {first, paint}, fewer});
    cases.push_back(
        {"a threshold of what is visible in a box", volume, {first, paint, drill}, within});
    cases.push_back(
        {"a threshold while another is locked", volume, {first, seeds, second, others, some, lock},
            ThresholdSegment{.segment = 2, .lower = 0.0, .overwriteUnlocked = true}});
    cases.push_back({"a threshold of no voxel", volume, {first},
        ThresholdSegment{.segment = 1, .lower = 2000.0}});
    cases.push_back({"growth after a threshold", volume, {first, paint, tissue, seeds}, all});
    cases.push_back(
        {"undo only a threshold", volume, {first, paint, more, drill}, revertRows({3})});
    cases.push_back({"merge layers", volume, {layer, drill, other, brush}, merge});
    cases.push_back({"merge an empty layer", volume, {layer, other}, merge});
    cases.push_back({"delete a layer", volume, {layer, drill, other}, removeLayer});
    cases.push_back({"delete a muted layer", volume,
        {layer, other, core::ChangeLayer{.layer = 2, .muted = true}}, removeLayer});
    cases.push_back({"add a layer after a deletion", volume, {layer, removeLayer}, layer});
    cases.push_back(
        {"solo", volume, {layer, drill, other}, core::ChangeLayer{.layer = 2, .solo = true}});
    cases.push_back({"drill into a solo layer", volume,
        {layer, drill, core::ChangeLayer{.layer = 2, .solo = true}}, other});
    cases.push_back({"undo only a segment to layer", volume,
        {first, seeds, all, layer, cover, lock}, revertRows({5})});
    cases.push_back({"undo only all but a segment", volume,
        {first, seeds, all, layer, allBut, lock}, revertRows({5})});
    cases.push_back({"undo only a layer to segment", volume,
        {first, drill, core::LayerToSegment{.layer = 1, .target = toFirst}, drillBack},
        revertRows({3})});
    cases.push_back({"revise a drill on a carved segment", volume,
        {first, seeds, all, core::SegmentToLayer{.segment = 1, .layer = 1}, drill, beside},
        core::ReviseStroke{.row = 5, .radiusMm = factsOfStroke(drill).mask.radiusMm * 1.5}});
    cases.push_back({"remove a bookmark", volume, {bookmark}, core::RemoveBookmark{.bookmark = 1}});
}

void addPieceStrokes(std::vector<StrokeCase>& cases, const StrokeScene& scene)
{
    const core::LoadedVolume& volume = scene.volume;
    const core::Edit& first = scene.first;
    const core::Edit& seeds = scene.seeds;
    const core::Edit& all = scene.all;
    const core::Edit& drill = scene.drill;

    const core::Edit lift = core::CutPiece{.layer = 1, .name = QStringLiteral("Lid")};
    const core::Edit aside = core::ChangePiece{.piece = 1,
        .offsetMm = glm::dvec3(12.5, -3, 0),
        .rotationDegrees = glm::dvec3(0, 30, 0),
        .zoom = 1.5};
    cases.push_back({"piece", volume, {drill}, lift});
    cases.push_back({"move a piece", volume, {drill, lift}, aside});
    cases.push_back({"drill into a piece's layer", volume, {drill, lift, aside}, drill});
    cases.push_back({"pieces home", volume, {drill, lift, aside}, core::SendPiecesHome{}});
    cases.push_back({"remove a piece", volume, {drill, lift}, core::RemovePiece{.piece = 1}});
    cases.push_back({"piece of a segment", volume, {first},
        core::PastePiece{.segment = 1, .name = QStringLiteral("Copy")}});
    cases.push_back({"delete a segment with its piece", volume,
        {first, core::PastePiece{.segment = 1, .name = QStringLiteral("Copy")}},
        core::RemoveSegment{.segment = 1}});

    const core::Edit shield = core::ChangeSegment{.segment = 1, .uncarvable = true};
    cases.push_back({"protect a segment", volume, {first}, shield});
    cases.push_back(
        {"drill beside a protected segment", volume, {first, seeds, all, shield}, drill});
    cases.push_back({"restore a protected segment", volume, {first, seeds, all, drill, shield},
        drillWith({.restore = true}, drill)});
    const core::AddMeasurement length{
        .fromLps = glm::dvec3(1, 2, 3), .toLps = glm::dvec3(4, 6, 3), .piece = {}};
    core::AddMeasurement onPiece = length;
    onPiece.piece = 1;
    cases.push_back({"measure", volume, {}, length});
    cases.push_back({"measure on a piece", volume, {drill, lift}, onPiece});
    cases.push_back(
        {"remove a measurement", volume, {length}, core::RemoveMeasurement{.measurement = 1}});
    core::AddMeasurement onSlab = length;
    onSlab.projected = true;
    cases.push_back({"measure on a slab", volume, {}, onSlab});
    using Kind = core::Measurement::Kind;
    const glm::dvec3 at(1, 2, 3);
    const glm::dvec3 right(8, 2, 3);
    const glm::dvec3 down(1, 6, 5);
    const core::Annotate angle{.kind = Kind::Angle, .pointsLps = {right, at, down}};
    const core::Annotate ellipse{.kind = Kind::Ellipse, .pointsLps = {at, right, down}};
    core::Annotate box = ellipse;
    box.kind = Kind::Rectangle;
    core::Annotate angleOnPiece = angle;
    angleOnPiece.piece = 1;
    angleOnPiece.projected = true;
    cases.push_back({"angle", volume, {length}, angle});
    cases.push_back({"angle on a piece", volume, {drill, lift}, angleOnPiece});
    cases.push_back({"ellipse", volume, {}, ellipse});
    cases.push_back({"rectangle", volume, {}, box});
    cases.push_back({"outline", volume, {},
        core::Annotate{.kind = Kind::Outline, .pointsLps = {at, right, right + down - at, down}}});
    cases.push_back(
        {"ball", volume, {}, core::Annotate{.kind = Kind::Ball, .pointsLps = {at, right}}});
    cases.push_back({"probe", volume, {}, core::Annotate{.kind = Kind::Probe, .pointsLps = {at}}});
    cases.push_back(
        {"arrow", volume, {}, core::Annotate{.kind = Kind::Arrow, .pointsLps = {at, right}}});
    cases.push_back({"move a distance", volume, {length},
        core::MoveMeasurement{.measurement = 1, .pointsLps = {at, down}}});
    cases.push_back({"move an ellipse", volume, {length, ellipse},
        core::MoveMeasurement{.measurement = 2, .pointsLps = {down, right, at}}});
    const core::Annotate text{
        .kind = Kind::Text, .pointsLps = {at}, .text = QStringLiteral("Fissure")};
    cases.push_back({"text", volume, {}, text});
    cases.push_back(
        {"remove a text", volume, {length, text}, core::RemoveMeasurement{.measurement = 2}});
}

} // namespace test
