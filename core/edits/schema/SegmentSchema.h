// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/parts/SegmentChoice.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/MoveSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/segments/SegmentSeen.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/edits/schema/EditMasks.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

template <> inline constexpr const char* editName<AddSegment> = "addSegment";
template <>
inline constexpr const char* editMeaning<AddSegment> =
    "Adds an empty segment. Segments are numbered 1, 2, 3 … in the order they are added, and a "
    "number is never used again.";
template <class Visitor> void visitFields(Visitor& visit, AddSegment& edit)
{
    visitName(visit, edit.name);
    visit.field("color", Presence::Required, edit.rgb, editFields::Colour{}, "the display colour");
    visit.field("code", Presence::Optional, edit.code, editFields::Code{},
        "the code that says what it is, e.g. [\"SCT\", \"89546000\", \"Skull\"]; [] means \"not "
        "coded yet\"");
    visit.maybe("plane", edit.plane, labelPlane,
        "its label plane: segments of different planes may share voxels", "the first, 0");
}

template <> inline constexpr const char* editName<ChangeSegment> = "changeSegment";
template <>
inline constexpr const char* editMeaning<ChangeSegment> =
    "Renames, recolours, codes or locks a segment, or protects it from sculpting; fields left out "
    "stay as they are.";
template <class Visitor> void visitFields(Visitor& visit, ChangeSegment& edit)
{
    visitSegment(visit, edit.segment);
    visit.maybe("name", edit.name, editFields::Text{}, "the new name");
    visit.maybe("color", edit.rgb, editFields::Colour{}, "the new display colour");
    visit.maybe("code", edit.code, editFields::Code{},
        "the code that says what it is; [] takes the code away");
    visit.maybe("locked", edit.locked, editFields::Flag{},
        "whether no tool and no growth may change its voxels");
    visit.maybe("protected", edit.uncarvable, editFields::Flag{},
        "whether no sculpting tool carves where it is");
}

template <> inline constexpr const char* editName<MoveSegment> = "moveSegment";
template <>
inline constexpr const char* editMeaning<MoveSegment> =
    "Puts a segment at another place of the list.";
template <class Visitor> void visitFields(Visitor& visit, MoveSegment& edit)
{
    visitSegment(visit, edit.segment);
    visit.field("place", Presence::Required, edit.place, editFields::WholeNumber{1, 255},
        "its new place in the list, where 1 is the first");
}

template <> inline constexpr const char* editName<RemoveSegment> = "removeSegment";
template <>
inline constexpr const char* editMeaning<RemoveSegment> =
    "Deletes a segment that is not locked, with its voxels and seeds.";
template <class Visitor> void visitFields(Visitor& visit, RemoveSegment& edit)
{
    visitSegment(visit, edit.segment);
}

template <> inline constexpr const char* editName<InvertSegment> = "invertSegment";
template <>
inline constexpr const char* editMeaning<InvertSegment> =
    "Gives a segment that is not locked every voxel that no segment has, in the whole volume, "
    "and frees those that it had.";
template <class Visitor> void visitFields(Visitor& visit, InvertSegment& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<CleanSegment> = "cleanSegment";
template <>
inline constexpr const char* editMeaning<CleanSegment> =
    "Fills holes of a segment that is not locked, removes islands from it, or gives one to another "
    "segment. Other segments keep their voxels. Does nothing if there is no such hole or island.";
template <class Visitor> void visitFields(Visitor& visit, CleanSegment& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visit.field("rule", Presence::Required, edit.rule,
        editFields::Choice<IslandRule, 6>{{"fillHoles", "keepLargest", "removeSmall", "keepClicked",
            "removeClicked", "giveClicked"}},
        "holes are surrounded on all sides; islands do not touch each other, not even at a corner");
    visit.maybe("mm3", edit.mm3, editFields::Number{"mm³", 0.0, 1e9, quantum::perCubicMillimetre},
        "the largest hole that is filled, or the smallest island that stays, without which "
        "removeSmall is refused",
        "every hole is filled");
    visit.maybe("islandLps", edit.islandLps, positionLps,
        "for keepClicked, removeClicked and giveClicked, a place in the island, in patient "
        "coordinates (LPS)",
        "the rule is about no single island");
    visit.maybe("to", edit.to, segmentNumber,
        "for giveClicked, the segment that receives the island; it must not be locked either",
        "no island is given away");
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<CombineSegments> = "combineSegments";
template <>
inline constexpr const char* editMeaning<CombineSegments> =
    "Gives a segment voxels of another one, exchanges theirs, or takes some away by the other. The "
    "segment may not be locked, nor may the other one for merge and swap.";
template <class Visitor> void visitFields(Visitor& visit, CombineSegments& edit)
{
    visitSegment(visit, edit.segment);
    visit.field("with", Presence::Required, edit.with, segmentNumber, "the other segment");
    visit.field("how", Presence::Required, edit.how,
        editFields::Choice<CombineSegments::How, 5>{
            {"merge", "swap", "union", "subtract", "intersect"}},
        "merge gives the segment the voxels of the other, which stays in the list, empty, or, if "
        "it lies in another label plane, keeps those that are not free in the segment's; swap "
        "gives each of them the voxels of the other, and needs segments of one label plane. The "
        "others need segments of different planes (importMask, addSegment, copySegment) and leave "
        "the other as it is: union adds its voxels where no segment of the plane lies, subtract "
        "takes away what it has, intersect what it has not");
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<ReshapeSegment> = "reshapeSegment";
template <>
inline constexpr const char* editMeaning<ReshapeSegment> =
    "Grows or shrinks a segment that is not locked by a margin, leaves a shell of it, opens, "
    "closes or smooths it, with a ball or a Gaussian of millimetres. Takes only voxels that no "
    "segment has.";
template <class Visitor> void visitFields(Visitor& visit, ReshapeSegment& edit)
{
    visitSegment(visit, edit.segment);
    visit.field("operation", Presence::Required, edit.operation,
        editFields::Choice<ShapeOperation, 8>{
            {"grow", "shrink", "hollow", "open", "close", "median", "wrap", "gaussian"}},
        "grow and shrink move the border by a margin; hollow leaves a shell; open removes what no "
        "ball inside the segment covers, close adds what no ball outside it covers; median gives "
        "each voxel to the side on which more than half of the ball around it lies, gaussian does "
        "so with a Gaussian instead of a ball; wrap adds holes and all that lies behind openings "
        "narrower than the ball");
    visit.field("mm", Presence::Required, edit.mm,
        editFields::Number{"mm", 0.01, 100.0, quantum::perMillimetre},
        "the margin, the thickness of the shell, the radius of the ball, or the standard deviation "
        "of the Gaussian");
    visit.maybe("shell", edit.shell,
        editFields::Choice<ShellPlace, 3>{{"inside", "centred", "outside"}},
        "for hollow only: where the shell lies with respect to the segment's border", "inside");
    visit.maybe("with", edit.with, editFields::SegmentList{},
        "for gaussian only: other segments that are not locked and are smoothed together with it; "
        "each voxel of theirs, or of none, goes to the one that is most around it, so that no gap "
        "opens; of segments that overlap (in several label planes) each plane for itself",
        "the segment alone");
    visit.maybe("flat", edit.flat, editFields::Flag{},
        "for median only: whether the ball is a disc in a study of a single slice", "false");
    const auto side = [&](const char* name, std::optional<double>& mm) {
        visit.maybe(name, mm, editFields::Number{"mm", 0.0, 100.0, quantum::perMillimetre},
            "for grow and shrink only: the margin on this side of the patient; 0 leaves this side "
            "as it is",
            "the value of mm");
    };
    side("rightMm", edit.sides.rightMm);
    side("leftMm", edit.sides.leftMm);
    side("anteriorMm", edit.sides.anteriorMm);
    side("posteriorMm", edit.sides.posteriorMm);
    side("inferiorMm", edit.sides.inferiorMm);
    side("superiorMm", edit.sides.superiorMm);
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<ThresholdSegment> = "thresholdSegment";
template <>
inline constexpr const char* editMeaning<ThresholdSegment> =
    "Makes a segment that is not locked of every voxel whose value lies in an interval, adds these "
    "voxels to it, or takes them from it.";
template <class Visitor> void visitFields(Visitor& visit, ThresholdSegment& edit)
{
    visitSegment(visit, edit.segment);
    visitOnlyValues(visit, edit.lower, edit.upper);
    visit.field("mode", Presence::Optional, edit.mode,
        editFields::Choice<ThresholdSegment::Mode, 3>{{"replace", "add", "subtract"}},
        "replace makes the segment of exactly these voxels; add gives them to it; subtract takes "
        "them from it");
    visit.field("onlyVisible", Presence::Optional, edit.onlyVisible, editFields::Flag{},
        "whether voxels that are carved away stay as they are");
    visit.maybe("box", edit.box, editFields::CornerPair{positionLps},
        "two opposite corners of a box; only voxels inside it change", "the whole volume");
    visitOverwrite(visit, edit.overwriteUnlocked);
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<PaintStroke> = "paint";
template <>
inline constexpr const char* editMeaning<PaintStroke> =
    "Paints a segment along a path, or erases it there.";
template <class Visitor> void visitFields(Visitor& visit, PaintStroke& edit)
{
    visitSegment(visit, edit.segment);
    visitPath(visit, edit.path);
    visit.field("erase", Presence::Optional, edit.erase, editFields::Flag{},
        "whether voxels of the segment are taken away instead");
    visitOnlyValues(visit, edit.lower, edit.upper);
    visitOverwrite(visit, edit.overwriteUnlocked);
    visit.field("seeds", Presence::Optional, edit.seeds, editFields::Flag{},
        "whether the painted voxels are seeds, from which the next growth goes on");
    visit.maybe("edgeTolerance", edit.edgeTolerance,
        editFields::Number{"modality units", 0.0, quantum::unbounded, 0.0},
        "makes the brush follow edges: it takes only voxels whose values differ by at most this "
        "from the value where the path begins (a median of the voxels around), and that such "
        "voxels under the brush join to the path",
        "all that is under the brush");
    visitEditable(visit, edit.editable);
    visit.maybe("tool", edit.tool, editFields::Choice<PaintStroke::Tool, 1>{{"nudge"}},
        "nudge is a disc that pushes the border of the segment in one slice, outwards, or inwards "
        "with erase; the history names it, but no voxel depends on it",
        "a brush");
    visit.maybe("toleranceByPressure", edit.toleranceByPressure, editFields::Flag{},
        "whether pressures are shares of edgeTolerance instead of the radius, which then stays "
        "whole",
        "false");
}

template <> inline constexpr const char* editName<FillOutline> = "fillOutline";
template <>
inline constexpr const char* editMeaning<FillOutline> =
    "Gives a segment what lies inside a closed outline in one slice, which may be oblique and is "
    "one voxel thick, or takes it away there.";
template <class Visitor> void visitFields(Visitor& visit, FillOutline& edit)
{
    constexpr editFields::Point direction{
        editFields::Number{"", -1000.0, 1000.0, quantum::perDirection}};
    visitSegment(visit, edit.segment);
    visit.field("originLps", Presence::Required, edit.originLps, positionLps,
        "a place in the slice, in patient coordinates (LPS)");
    visit.field("rightLps", Presence::Required, edit.rightLps, direction,
        "a direction in the slice, in patient coordinates (LPS)");
    visit.field("upLps", Presence::Required, edit.upLps, direction,
        "another direction in the slice; only the part of it that is perpendicular to rightLps "
        "counts");
    visit.field("polygonMm", Presence::Required, edit.polygonMm,
        editFields::Outline{editFields::Number{"mm", -2000.0, 2000.0, quantum::perMillimetre}},
        "a closed curve in the slice, as points to the right and up from the origin; inside is "
        "what it winds around, and the curve itself");
    visit.field("erase", Presence::Optional, edit.erase, editFields::Flag{},
        "whether voxels of the segment are taken away instead");
    visitOnlyValues(visit, edit.lower, edit.upper);
    visitOverwrite(visit, edit.overwriteUnlocked);
    visitEditable(visit, edit.editable);
}

/// The segment that receives voxels.
template <class Visitor> void visitTarget(Visitor& visit, SegmentChoice& target)
{
    visit.maybe("segment", target.segment, segmentNumber,
        "the segment that receives the voxels; name and color are left out then", "a new segment");
    visit.when(!target.segment, [&] {
        visit.field("name", Presence::Required, target.name, editFields::Text{},
            "the name of the new segment, if no segment is given");
        visit.field("color", Presence::Required, target.rgb, editFields::Colour{},
            "the colour of the new segment, if no segment is given");
    });
}

template <> inline constexpr const char* editName<LayerToSegment> = "layerToSegment";
template <>
inline constexpr const char* editMeaning<LayerToSegment> =
    "Gives what a sculpt layer has carved, with a coverage of at least one half, to a segment; "
    "does nothing if it takes no voxel.";
template <class Visitor> void visitFields(Visitor& visit, LayerToSegment& edit)
{
    visitLayer(visit, edit.layer);
    visitTarget(visit, edit.target);
    visitOverwrite(visit, edit.overwriteUnlocked);
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<SegmentSeen> = "segmentSeen";
template <>
inline constexpr const char* editMeaning<SegmentSeen> =
    "Gives a segment all that can be seen from any side: what no layer carves and no clipping "
    "hides, with values in an interval; does nothing if it takes no voxel.";
template <class Visitor> void visitFields(Visitor& visit, SegmentSeen& edit)
{
    visitTarget(visit, edit.target);
    visitOnlyValues(visit, edit.lower, edit.upper);
    visitHidden(visit, edit.hidden);
    visitOverwrite(visit, edit.overwriteUnlocked);
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<ImportMask> = "importMask";
template <>
inline constexpr const char* editMeaning<ImportMask> =
    "Imports the segments of a mask file; does nothing if they take no voxel. A row of the history "
    "holds their voxels and no longer needs the file.";
template <class Visitor> void visitFields(Visitor& visit, ImportMask& edit)
{
    visit.field("file", Presence::Required, edit.file, editFields::FileName{},
        "the file, or a folder of such files: labels in NIfTI, NRRD, .seg.nrrd or MetaImage, a "
        "DICOM SEG or RTSTRUCT, or surfaces in STL, OBJ, PLY or glTF");
    visit.maybe("as", edit.as, editFields::SegmentReference{},
        "the segment that receives everything: the number of an existing one, or a name, for which "
        "a segment is made if there is none",
        "each segment of the file becomes a new one");
    visitOverwrite(visit, edit.overwriteUnlocked);
    visit.maybe("size", edit.size, editFields::GridSize{},
        "the size of the volume to which the voxels belong",
        "the file is read together with the recipe");
    visit.maybe("segments", edit.segments, editFields::ImportedSegmentList{},
        "what the file held, on the volume's grid, with voxels as packed runs",
        "the file is read together with the recipe");
    visit.maybe("ahead", edit.ahead, editFields::EntryOrder{},
        "which segments keep the voxels where several overlap, the foremost first; given by their "
        "places, from 1, among the imported ones",
        "the file's order");
    visit.maybe("planes", edit.planes, editFields::PlaneList{},
        "the label plane of each imported segment: those in different planes keep the voxels that "
        "they share, those in one plane do not",
        "as few planes as they need, if segments of the file overlap and 'ahead' says nothing; "
        "otherwise plane 0 for all");
}

} // namespace core::editSchema
