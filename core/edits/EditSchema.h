// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/EditFields.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/Edits.h"

#include <algorithm>
#include <initializer_list>

namespace core::editSchema {

/// Whether a field may be left out; then it has the value of a default-constructed edit.
enum class Presence { Required, Optional };

// The one place that knows the fields of each edit. visitFields() shows them to a visitor, which
// reads, writes, checks, rounds or documents them:
//
//   field(name, presence, value, kind, meaning)    kind: editFields
//   maybe(name, std::optional value, kind, meaning, absent)  may be left out; absent says what
//                                                  that means, by itself "unchanged"
//   constant(name, presence, json, meaning)        only this value is known
//   group(name, meaning, visitInside)              an object of its own
//   when(condition, visitInside)                   fields that are there only then
//
// editName<E> is the value of "edit" in JSON, editMeaning<E> its line in the documentation.

template <class E> inline constexpr const char* editName = nullptr;
template <> inline constexpr const char* editName<AddSegment> = "addSegment";
template <> inline constexpr const char* editName<ChangeSegment> = "changeSegment";
template <> inline constexpr const char* editName<MoveSegment> = "moveSegment";
template <> inline constexpr const char* editName<RemoveSegment> = "removeSegment";
template <> inline constexpr const char* editName<AddLayer> = "addLayer";
template <> inline constexpr const char* editName<ChangeLayer> = "changeLayer";
template <> inline constexpr const char* editName<MoveLayer> = "moveLayer";
template <> inline constexpr const char* editName<AddBookmark> = "addBookmark";
template <> inline constexpr const char* editName<RemoveBookmark> = "removeBookmark";
template <> inline constexpr const char* editName<SeedStroke> = "seed";
template <> inline constexpr const char* editName<GrowSteps> = "grow";
template <> inline constexpr const char* editName<DrillStroke> = "drill";
template <> inline constexpr const char* editName<RevertRows> = "revert";
template <> inline constexpr const char* editName<ReviseStroke> = "reviseStroke";
template <> inline constexpr const char* editName<PaintStroke> = "paint";
template <> inline constexpr const char* editName<BrushStroke> = "brush";
template <> inline constexpr const char* editName<PeelCut> = "peel";
template <> inline constexpr const char* editName<ScissorsCut> = "scissors";
template <> inline constexpr const char* editName<RemoveLayer> = "removeLayer";
template <> inline constexpr const char* editName<MergeLayers> = "mergeLayers";
template <> inline constexpr const char* editName<LayerToSegment> = "layerToSegment";
template <> inline constexpr const char* editName<SegmentToLayer> = "segmentToLayer";
template <> inline constexpr const char* editName<SegmentSeen> = "segmentSeen";
template <> inline constexpr const char* editName<CutPiece> = "cutPiece";
template <> inline constexpr const char* editName<PastePiece> = "pastePiece";
template <> inline constexpr const char* editName<ChangePiece> = "changePiece";
template <> inline constexpr const char* editName<SendPiecesHome> = "sendPiecesHome";
template <> inline constexpr const char* editName<RemovePiece> = "removePiece";
template <> inline constexpr const char* editName<LaserStroke> = "laser";

template <class E> inline constexpr const char* editMeaning = nullptr;
template <>
inline constexpr const char* editMeaning<AddSegment> =
    "Adds an empty segment. Segments are numbered 1, 2, 3 … in the order they are added, and a "
    "number is never used again.";
template <>
inline constexpr const char* editMeaning<ChangeSegment> =
    "Renames, recolours, codes or locks a segment; fields left out stay as they are.";
template <>
inline constexpr const char* editMeaning<MoveSegment> =
    "Puts a segment at another place of the list.";
template <>
inline constexpr const char* editMeaning<RemoveSegment> =
    "Deletes a segment that is not locked, with its voxels and seeds.";
template <>
inline constexpr const char* editMeaning<AddLayer> =
    "Adds an empty sculpt layer. Layer 1 is there from the start; others are numbered 2, 3 … in "
    "the order they are added, and a number is never used again.";
template <>
inline constexpr const char* editMeaning<ChangeLayer> =
    "Renames or mutes a sculpt layer, or has it count alone; fields left out stay as they are.";
template <>
inline constexpr const char* editMeaning<MoveLayer> =
    "Puts a sculpt layer at another place of the list.";
template <>
inline constexpr const char* editMeaning<AddBookmark> =
    "Keeps a view of the patient by name. Bookmarks are numbered 1, 2, 3 … in the order they are "
    "added.";
template <>
inline constexpr const char* editMeaning<RemoveBookmark> = "Forgets a view that was kept.";
template <>
inline constexpr const char* editMeaning<SeedStroke> =
    "Marks the voxels nearest to some points as seeds of a segment; the next growth starts there.";
template <>
inline constexpr const char* editMeaning<GrowSteps> =
    "Grows all seeded segments breadth-first through voxels whose value lies in an interval.";
template <>
inline constexpr const char* editMeaning<DrillStroke> =
    "Carves with a drill along the view direction, from the visible surface inward.";
template <>
inline constexpr const char* editMeaning<RevertRows> =
    "Undoes older strokes and growths only, where nothing wrote or read the same place since.";

template <>
inline constexpr const char* editMeaning<ReviseStroke> =
    "Changes or removes an older cut of drill, peel, scissors or brush; what later strokes cut "
    "stays.";
template <>
inline constexpr const char* editMeaning<PaintStroke> =
    "Paints a segment along a path, or erases it there.";
template <>
inline constexpr const char* editMeaning<BrushStroke> =
    "Carves along a path, or restores what was carved there.";
template <>
inline constexpr const char* editMeaning<PeelCut> =
    "Takes a shell of even thickness off the visible surface inside a closed curve.";
template <>
inline constexpr const char* editMeaning<ScissorsCut> =
    "Cuts out what lies inside a closed curve along the view, or restores what was carved there.";
template <>
inline constexpr const char* editMeaning<RemoveLayer> =
    "Deletes a sculpt layer with what it has carved; not the only one.";
template <>
inline constexpr const char* editMeaning<MergeLayers> =
    "Lays what a sculpt layer has carved into another one, and deletes it.";
template <>
inline constexpr const char* editMeaning<LayerToSegment> =
    "Gives what a sculpt layer has carved (coverage of one half and more) to a segment; does "
    "nothing "
    "where it takes no voxel.";
template <>
inline constexpr const char* editMeaning<SegmentToLayer> =
    "Carves what a segment holds, whole, into a sculpt layer.";
template <>
inline constexpr const char* editMeaning<SegmentSeen> =
    "Gives what is seen, from wherever, to a segment: what no layer carves, inside the clip "
    "region, "
    "with values in an interval; does nothing where it takes no voxel.";
template <>
inline constexpr const char* editMeaning<CutPiece> =
    "Makes what a sculpt layer has cut out a piece, which can be shown elsewhere. Pieces are "
    "numbered 1, 2, 3 … in the order they are made, and a number is never used again.";
template <>
inline constexpr const char* editMeaning<PastePiece> =
    "Shows a segment as a piece of its own, besides where it is.";
template <>
inline constexpr const char* editMeaning<ChangePiece> =
    "Renames, moves, turns or zooms a piece; fields left out stay as they are.";
template <>
inline constexpr const char* editMeaning<SendPiecesHome> =
    "Shows every piece at its true place and in its true size.";
template <>
inline constexpr const char* editMeaning<RemovePiece> =
    "Makes a piece one no more; what cut it stays cut.";
template <>
inline constexpr const char* editMeaning<LaserStroke> =
    "Carves with a mask that stands across the visible surface and goes in along its normal.";

inline constexpr editFields::WholeNumber segmentNumber{1, 255};
inline constexpr editFields::WholeNumber layerNumber{1, 254};
inline constexpr editFields::WholeNumber bookmarkNumber{1, 1000000};
inline constexpr editFields::WholeNumber pieceNumber{1, 1000000};
inline constexpr editFields::Number pieceTurn{"degrees", -360.0, 360.0, quantum::perDegree};
inline constexpr editFields::Number pieceZoom{"", 0.125, 16.0, quantum::perZoom};
inline constexpr editFields::Number modalityValue{
    "modality units", -quantum::unbounded, quantum::unbounded, 0.0};
inline constexpr editFields::Number millimetres{
    "mm", -quantum::reachMm, quantum::reachMm, quantum::perMillimetre};
inline constexpr editFields::Point positionLps{millimetres};
inline constexpr editFields::Number drillRadius{"mm", 0.01, 200.0, quantum::perMillimetre};
inline constexpr editFields::Number brushRadius{"mm", 0.01, 200.0, quantum::perMillimetre};
inline constexpr editFields::Number drillDepth{"mm", 0.0, 500.0, quantum::perMillimetre};
inline constexpr editFields::Number peelDepth{"mm", 0.0, 60.0, quantum::perMillimetre};
inline constexpr editFields::Outline viewOutline{
    editFields::Number{"mm", -2000.0, 2000.0, quantum::perMillimetre}};
inline constexpr editFields::Number maskSide{"mm", 0.02, 400.0, quantum::perMillimetre};
inline constexpr editFields::Number maskSoftness{"mm", 0.0, 200.0, quantum::perMillimetre};
inline constexpr editFields::Outline maskOutline{
    editFields::Number{"mm", -200.0, 200.0, quantum::perMillimetre}};

/// A camera, as every edit that needs one writes it.
template <class Visitor> void visitView(Visitor& visit, OrthographicView& view)
{
    using namespace editFields;
    visit.group("view", "the camera, orthographic", [&](auto& inside) {
        inside.field("eyeLps", Presence::Required, view.eyeLps, positionLps,
            "where the viewer stands, patient coordinates (LPS)");
        inside.field("targetLps", Presence::Required, view.targetLps, positionLps,
            "the middle of the view plane, patient coordinates (LPS)");
        inside.field("up", Presence::Required, view.up,
            Point{Number{"", -1000.0, 1000.0, quantum::perDirection}},
            "a direction that points upwards in the view, patient coordinates (LPS)");
        inside.field("heightMm", Presence::Required, view.heightMm,
            Number{"mm", 1.0 / quantum::perMillimetre, quantum::reachMm, quantum::perMillimetre},
            "what the view's height shows; decides no voxel");
        inside.constant(
            "orthographic", Presence::Optional, true, "perspective views are converted");
    });
}

template <class Visitor> void visitFields(Visitor& visit, AddSegment& edit)
{
    visit.field("name", Presence::Required, edit.name, editFields::Text{}, "shown in the list");
    visit.field("color", Presence::Required, edit.rgb, editFields::Colour{}, "display colour");
    visit.field("code", Presence::Optional, edit.code, editFields::Code{},
        "what it is, e.g. [\"SCT\", \"89546000\", \"Skull\"]; [] is \"not coded yet\"");
}

template <class Visitor> void visitFields(Visitor& visit, ChangeSegment& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visit.maybe("name", edit.name, editFields::Text{}, "new name");
    visit.maybe("color", edit.rgb, editFields::Colour{}, "new display colour");
    visit.maybe("code", edit.code, editFields::Code{}, "what it is; [] takes the code away");
    visit.maybe("locked", edit.locked, editFields::Flag{},
        "whether its voxels are kept from every tool and growth");
}

template <class Visitor> void visitFields(Visitor& visit, MoveSegment& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visit.field("place", Presence::Required, edit.place, segmentNumber,
        "its new place in the list, 1 is the first");
}

template <class Visitor> void visitFields(Visitor& visit, RemoveSegment& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
}

template <class Visitor> void visitFields(Visitor& visit, AddLayer& edit)
{
    visit.field("name", Presence::Required, edit.name, editFields::Text{}, "shown in the list");
}

template <class Visitor> void visitFields(Visitor& visit, ChangeLayer& edit)
{
    visit.field("layer", Presence::Required, edit.layer, layerNumber, "which sculpt layer");
    visit.maybe("name", edit.name, editFields::Text{}, "new name");
    visit.maybe("muted", edit.muted, editFields::Flag{},
        "whether it hides nothing, as if it were not there");
    visit.maybe("solo", edit.solo, editFields::Flag{},
        "whether all layers that are not solo hide nothing, as if muted");
}

template <class Visitor> void visitFields(Visitor& visit, MoveLayer& edit)
{
    visit.field("layer", Presence::Required, edit.layer, layerNumber, "which sculpt layer");
    visit.field("place", Presence::Required, edit.place, layerNumber,
        "its new place in the list, 1 is the first");
}

template <class Visitor> void visitFields(Visitor& visit, RemoveLayer& edit)
{
    visit.field("layer", Presence::Required, edit.layer, layerNumber, "which sculpt layer");
}

template <class Visitor> void visitFields(Visitor& visit, MergeLayers& edit)
{
    visit.field("from", Presence::Required, edit.from, layerNumber,
        "the sculpt layer that is laid into the other and deleted");
    visit.field("into", Presence::Required, edit.into, layerNumber,
        "the sculpt layer that stays; muted if the other is, and not if it is not");
}

/// Which segment receives voxels.
template <class Visitor> void visitTarget(Visitor& visit, SegmentChoice& target)
{
    visit.maybe(
        "segment", target.segment, segmentNumber, "which segment; no name then", "a new one");
    visit.when(!target.segment, [&] {
        visit.field("name", Presence::Required, target.name, editFields::Text{},
            "of the new segment (no segment given)");
        visit.field("color", Presence::Required, target.rgb, editFields::Colour{},
            "of the new segment (no segment given)");
    });
}

template <class Visitor> void visitFields(Visitor& visit, LayerToSegment& edit)
{
    visit.field("layer", Presence::Required, edit.layer, layerNumber, "which sculpt layer");
    visitTarget(visit, edit.target);
    visit.field("overwriteUnlocked", Presence::Optional, edit.overwriteUnlocked, editFields::Flag{},
        "whether voxels of other segments that are not locked are taken");
}

template <class Visitor> void visitFields(Visitor& visit, SegmentToLayer& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visit.field("layer", Presence::Required, edit.layer, layerNumber,
        "the sculpt layer that is carved; not a muted one");
}

/// What a clip box or planes hid when the cut was made.
template <class Visitor> void visitHidden(Visitor& visit, HiddenSides& hidden)
{
    visit.maybe("hidden", hidden, editFields::HiddenSideList{},
        "what is not seen, so that the cut neither starts nor cuts there: where normal · place > "
        "offset, patient coordinates (LPS)",
        "nothing");
}

template <class Visitor> void visitFields(Visitor& visit, SegmentSeen& edit)
{
    visitTarget(visit, edit.target);
    visit.maybe(
        "lower", edit.lower, modalityValue, "only voxels from this value on, inclusive", "any");
    visit.maybe(
        "upper", edit.upper, modalityValue, "only voxels up to this value, inclusive", "any");
    visitHidden(visit, edit.hidden);
    visit.field("overwriteUnlocked", Presence::Optional, edit.overwriteUnlocked, editFields::Flag{},
        "whether voxels of other segments that are not locked are taken");
}

template <class Visitor> void visitFields(Visitor& visit, AddBookmark& edit)
{
    visit.field("name", Presence::Required, edit.name, editFields::Text{}, "shown in the menu");
    visitView(visit, edit.view);
    visit.field("crosshairLps", Presence::Required, edit.crosshairLps, positionLps,
        "where the slices cross, patient coordinates (LPS)");
}

template <class Visitor> void visitFields(Visitor& visit, RemoveBookmark& edit)
{
    visit.field("bookmark", Presence::Required, edit.bookmark, bookmarkNumber, "which bookmark");
}

template <class Visitor> void visitPivot(Visitor& visit, std::optional<glm::dvec3>& pivotLps)
{
    visit.maybe("pivotLps", pivotLps, positionLps,
        "what it turns and is zoomed about, at its true place, patient coordinates (LPS)",
        "the middle of the volume");
}

template <class Visitor> void visitFields(Visitor& visit, CutPiece& edit)
{
    visit.field("layer", Presence::Optional, edit.layer, layerNumber,
        "the sculpt layer that cut it; not that of another piece");
    visit.field("name", Presence::Required, edit.name, editFields::Text{}, "shown in the list");
    visitPivot(visit, edit.pivotLps);
}

template <class Visitor> void visitFields(Visitor& visit, PastePiece& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visit.field("name", Presence::Required, edit.name, editFields::Text{}, "shown in the list");
    visitPivot(visit, edit.pivotLps);
    visit.field("offsetMm", Presence::Optional, edit.pose.offsetMm, positionLps,
        "from its true place, along the patient's axes (LPS)");
    visit.field("rotationDegrees", Presence::Optional, edit.pose.rotationDegrees,
        editFields::Point{pieceTurn},
        "its direction is the axis (LPS), its length the angle: [0, 0, 90] turns about S");
    visit.field("zoom", Presence::Optional, edit.pose.zoom, pieceZoom, "1: true size");
}

template <class Visitor> void visitFields(Visitor& visit, ChangePiece& edit)
{
    visit.field("piece", Presence::Required, edit.piece, pieceNumber, "which piece");
    visit.maybe("name", edit.name, editFields::Text{}, "new name");
    visit.maybe("offsetMm", edit.offsetMm, positionLps,
        "from its true place, along the patient's axes (LPS)");
    visit.maybe("rotationDegrees", edit.rotationDegrees, editFields::Point{pieceTurn},
        "its direction is the axis (LPS), its length the angle: [0, 0, 90] turns about S");
    visit.maybe("zoom", edit.zoom, pieceZoom, "1: true size");
}

template <class Visitor> void visitFields(Visitor&, SendPiecesHome&) { }

template <class Visitor> void visitFields(Visitor& visit, RemovePiece& edit)
{
    visit.field("piece", Presence::Required, edit.piece, pieceNumber, "which piece");
}

template <class Visitor> void visitFields(Visitor& visit, SeedStroke& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visit.field("pointsLps", Presence::Required, edit.pointsLps, editFields::PointList{positionLps},
        "patient coordinates (LPS), inside the volume");
}

template <class Visitor> void visitFields(Visitor& visit, GrowSteps& edit)
{
    visit.field(
        "lower", Presence::Required, edit.lower, modalityValue, "smallest value, inclusive");
    visit.field(
        "upper", Presence::Required, edit.upper, modalityValue, "greatest value, inclusive");
    visit.field("connectivity", Presence::Optional, edit.connectivity,
        editFields::WholeNumber{6, 6}, "neighbours of a voxel: those that share a face");
    visit.field("steps", Presence::Required, edit.steps, editFields::StepCount{},
        "rings to add after the seeds, or until nothing is left to add");
    visit.field("overwriteUnlocked", Presence::Optional, edit.overwriteUnlocked, editFields::Flag{},
        "whether growth takes voxels of other segments that are not locked");
}

template <class Visitor> void visitSurface(Visitor& visit, double& threshold)
{
    visit.group("surface", "what is seen, hence where a cut starts", [&](auto& inside) {
        inside.field("threshold", Presence::Required, threshold, modalityValue,
            "values from here on are material");
    });
}

/// What is pressed into the volume.
template <class Visitor> void visitMask(Visitor& visit, MaskShape& mask)
{
    using namespace editFields;
    using Kind = MaskShape::Kind;
    visit.group("mask", "what is pressed into the volume, parallel to the view", [&](auto& inside) {
        inside.maybe("polygonMm", mask.polygonMm, maskOutline,
            "a closed curve around the sample: right, up; no shape then", "a shape");
        inside.when(!mask.polygonMm, [&] {
            inside.field("shape", Presence::Required, mask.kind,
                Choice<Kind, 5>{{"circle", "ellipse", "square", "rectangle", "rounded"}},
                "what it looks like to the viewer");
        });
        const auto is = [&mask](std::initializer_list<Kind> kinds) {
            return !mask.polygonMm
                && std::find(kinds.begin(), kinds.end(), mask.kind) != kinds.end();
        };
        inside.when(is({Kind::Circle}), [&] {
            inside.field(
                "radiusMm", Presence::Required, mask.radiusMm, drillRadius, "radius (circle)");
        });
        inside.when(is({Kind::Square}), [&] {
            inside.field("sideMm", Presence::Required, mask.widthMm, maskSide, "its side (square)");
        });
        inside.when(is({Kind::Ellipse, Kind::Rectangle, Kind::Rounded}), [&] {
            inside.field("widthMm", Presence::Required, mask.widthMm, maskSide,
                "from left to right (ellipse, rectangle, rounded)");
            inside.field("heightMm", Presence::Required, mask.heightMm, maskSide,
                "from bottom to top (ellipse, rectangle, rounded)");
        });
        inside.when(is({Kind::Rounded}), [&] {
            inside.field("cornerMm", Presence::Required, mask.cornerMm, maskSide,
                "radius of its corners (rounded)");
        });
        inside.when(is({Kind::Ellipse, Kind::Square, Kind::Rectangle, Kind::Rounded}), [&] {
            inside.field("rotationDegrees", Presence::Optional, mask.rotationDegrees,
                Number{"degrees", -360.0, 360.0, 1024.0}, "counter-clockwise, not of a circle");
        });
        inside.field("softnessMm", Presence::Optional, mask.softnessMm, maskSoftness,
            "over so much from its edge inwards the depth rises to its full value; 0: a sharp "
            "edge");
    });
}

template <class Visitor> void visitFields(Visitor& visit, DrillStroke& edit)
{
    using namespace editFields;
    visit.field("layer", Presence::Optional, edit.layer, layerNumber,
        "the sculpt layer that is carved; not a muted one");
    visitView(visit, edit.view);
    visitMask(visit, edit.mask);
    visit.field("mode", Presence::Optional, edit.mode, Choice<DrillMode, 2>{{"limit", "rate"}},
        "whether depthMm is the most that one stroke cuts, or what it cuts a second");
    visit.field("depthMm", Presence::Required, edit.depthMm, drillDepth,
        "depth below the surface at full pressure");
    visit.when(edit.mode == DrillMode::Rate, [&] {
        visit.field("floorMm", Presence::Optional, edit.floorMm, drillDepth,
            "no deeper than this below the surface (mode rate)");
    });
    visit.field("pressureExponent", Presence::Optional, edit.pressureExponent, WholeNumber{1, 3},
        "depth = depthMm · pressure to this power");
    visitSurface(visit, edit.surfaceThreshold);
    visit.field("throughGaps", Presence::Optional, edit.throughGaps, Flag{},
        "whether the drill goes on behind a gap in the material");
    visit.field("guardMm", Presence::Optional, edit.guardMm, drillDepth,
        "parts of the surface under the mask that lie more than the depth and this behind its "
        "middle are seen through a gap and left alone; 0: all are cut");
    visit.field("restore", Presence::Optional, edit.restore, Flag{},
        "whether it fills again what was carved, from the surface towards the viewer");
    visit.field("byTime", Presence::Optional, edit.byTime, Flag{},
        "whether samples are points of a path in time, as a pen reports them, rather than its "
        "corners; in mode rate they always are");
    visit.field("samples", Presence::Required, edit.samples, SampleList{},
        "pen path in the view plane, relative to the target: right, up, pressure, time");
    visitHidden(visit, edit.hidden);
}

template <class Visitor> void visitFields(Visitor& visit, LaserStroke& edit)
{
    using namespace editFields;
    visit.field("layer", Presence::Optional, edit.layer, layerNumber,
        "the sculpt layer that is carved; not a muted one");
    visitView(visit, edit.view);
    visitMask(visit, edit.mask);
    visit.field("mode", Presence::Optional, edit.mode, Choice<DrillMode, 2>{{"limit", "rate"}},
        "whether depthMm is the most that one stroke cuts, or what it cuts a second");
    visit.field("depthMm", Presence::Required, edit.depthMm, drillDepth,
        "depth along the surface's normal at full pressure");
    visit.when(edit.mode == DrillMode::Rate, [&] {
        visit.field("floorMm", Presence::Optional, edit.floorMm, drillDepth,
            "no deeper than this below the surface (mode rate)");
    });
    visit.field("pressureExponent", Presence::Optional, edit.pressureExponent, WholeNumber{1, 3},
        "depth = depthMm · pressure to this power");
    visitSurface(visit, edit.surfaceThreshold);
    visit.field("throughGaps", Presence::Optional, edit.throughGaps, Flag{},
        "whether it goes on behind a gap in the material");
    visit.field("restore", Presence::Optional, edit.restore, Flag{},
        "whether it fills again what was carved, from the surface outwards");
    visit.field("byTime", Presence::Optional, edit.byTime, Flag{},
        "whether samples are points of a path in time, as a pen reports them, rather than its "
        "corners; in mode rate they always are");
    visit.field("samples", Presence::Required, edit.samples, SampleList{},
        "path of the mask's middle in the view plane, relative to the target: right, up, pressure, "
        "time");
    visitHidden(visit, edit.hidden);
}

template <class Visitor> void visitFields(Visitor& visit, RevertRows& edit)
{
    visit.field("rows", Presence::Required, edit.rows, editFields::RowList{},
        "rows of the history before this one, ascending (burin history: seq)");
}

template <class Visitor> void visitFields(Visitor& visit, ReviseStroke& edit)
{
    visit.field("row", Presence::Required, edit.row, editFields::Row{},
        "a cut of the history before this row (burin history: seq)");
    visit.maybe("radiusMm", edit.radiusMm, drillRadius, "another radius of a disc or brush");
    visit.maybe("depthMm", edit.depthMm, drillDepth, "another depth, not of a brush");
    visit.maybe("softnessMm", edit.softnessMm, maskSoftness, "another soft edge, of a drill");
    visit.maybe("layer", edit.layer, layerNumber, "another sculpt layer");
    visit.maybe("throughGaps", edit.throughGaps, editFields::Flag{},
        "whether it goes on behind a gap in the material");
    visit.field("removed", Presence::Optional, edit.removed, editFields::Flag{},
        "whether it is taken out altogether");
}

/// A brush and the way it went, as every edit that has one writes it.
template <class Visitor> void visitPath(Visitor& visit, BrushPath& path)
{
    using namespace editFields;
    visit.field(
        "radiusMm", Presence::Required, path.radiusMm, brushRadius, "radius of the ball or disc");
    visit.field("shape", Presence::Optional, path.shape, BrushShape{},
        "a ball, or a disc that lies in one plane and is one voxel thick");
    visit.maybe("normalLps", path.normalLps,
        Point{Number{"", -1000.0, 1000.0, quantum::perDirection}},
        "of a disc: a direction across its plane, which holds the first point", "none, of a ball");
    visit.field("pointsLps", Presence::Required, path.pointsLps, PointList{positionLps},
        "the path, straight from point to point, patient coordinates (LPS)");
    visit.field("lifts", Presence::Optional, path.lifts, PlaceList{},
        "points that the path does not run to but begins anew at, counted from 0");
}

template <class Visitor> void visitFields(Visitor& visit, PaintStroke& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visitPath(visit, edit.path);
    visit.field("erase", Presence::Optional, edit.erase, editFields::Flag{},
        "whether voxels of the segment are taken away instead");
    visit.maybe(
        "lower", edit.lower, modalityValue, "only voxels from this value on, inclusive", "any");
    visit.maybe(
        "upper", edit.upper, modalityValue, "only voxels up to this value, inclusive", "any");
    visit.field("overwriteUnlocked", Presence::Optional, edit.overwriteUnlocked, editFields::Flag{},
        "whether voxels of other segments that are not locked are taken");
    visit.field("seeds", Presence::Optional, edit.seeds, editFields::Flag{},
        "whether what is painted takes part in growth: the next one goes on from there");
}

template <class Visitor> void visitFields(Visitor& visit, BrushStroke& edit)
{
    visit.field("layer", Presence::Optional, edit.layer, layerNumber,
        "the sculpt layer that is carved; not a muted one");
    visitPath(visit, edit.path);
    visit.field("restore", Presence::Optional, edit.restore, editFields::Flag{},
        "whether carved voxels come back instead");
    visitHidden(visit, edit.hidden);
}

template <class Visitor> void visitFields(Visitor& visit, PeelCut& edit)
{
    using namespace editFields;
    visit.field("layer", Presence::Optional, edit.layer, layerNumber,
        "the sculpt layer that is carved; not a muted one");
    visitView(visit, edit.view);
    visit.field("polygonMm", Presence::Required, edit.polygonMm, viewOutline,
        "a closed curve in the view plane, relative to the target: right, up");
    visit.field(
        "depthMm", Presence::Required, edit.depthMm, peelDepth, "thickness of what is taken off");
    visitSurface(visit, edit.surfaceThreshold);
    visit.field("throughGaps", Presence::Optional, edit.throughGaps, Flag{},
        "whether it goes on behind a gap in the material");
    visit.field("jumpMm", Presence::Optional, edit.jumpMm, drillDepth,
        "where the surface jumps by more than this it is another one, and only the largest is "
        "peeled; 0: all of them");
    visit.field("restore", Presence::Optional, edit.restore, Flag{},
        "whether it fills again what was carved, from the surface outwards");
    visitHidden(visit, edit.hidden);
}

template <class Visitor> void visitFields(Visitor& visit, ScissorsCut& edit)
{
    using namespace editFields;
    visit.field("layer", Presence::Optional, edit.layer, layerNumber,
        "the sculpt layer that is carved; not a muted one");
    visitView(visit, edit.view);
    visit.field("polygonMm", Presence::Required, edit.polygonMm, viewOutline,
        "a closed curve in the view plane, relative to the target: right, up");
    visit.maybe(
        "depthMm", edit.depthMm, drillDepth, "depth below the surface", "through everything");
    visit.field("firstLayerOnly", Presence::Optional, edit.firstLayerOnly, Flag{},
        "whether it ends at the first gap in the material");
    visitSurface(visit, edit.surfaceThreshold);
    visit.field("restore", Presence::Optional, edit.restore, Flag{},
        "whether it fills again what was carved");
    visitHidden(visit, edit.hidden);
}

} // namespace core::editSchema
