// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/SegmentChoice.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/kinds/segments/ImportMask.h"
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
    visit.field("color", Presence::Required, edit.rgb, editFields::Colour{}, "display colour");
    visit.field("code", Presence::Optional, edit.code, editFields::Code{},
        "what it is, e.g. [\"SCT\", \"89546000\", \"Skull\"]; [] is \"not coded yet\"");
}

template <> inline constexpr const char* editName<ChangeSegment> = "changeSegment";
template <>
inline constexpr const char* editMeaning<ChangeSegment> =
    "Renames, recolours, codes or locks a segment, or protects it from sculpting; fields left out "
    "stay as they are.";
template <class Visitor> void visitFields(Visitor& visit, ChangeSegment& edit)
{
    visitSegment(visit, edit.segment);
    visit.maybe("name", edit.name, editFields::Text{}, "new name");
    visit.maybe("color", edit.rgb, editFields::Colour{}, "new display colour");
    visit.maybe("code", edit.code, editFields::Code{}, "what it is; [] takes the code away");
    visit.maybe("locked", edit.locked, editFields::Flag{},
        "whether its voxels are kept from every tool and growth");
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
        "its new place in the list, 1 is the first");
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
    "segment. Voxels of others stay theirs. Does nothing where there is none.";
template <class Visitor> void visitFields(Visitor& visit, CleanSegment& edit)
{
    visit.field("segment", Presence::Required, edit.segment, segmentNumber, "which segment");
    visit.field("rule", Presence::Required, edit.rule,
        editFields::Choice<IslandRule, 6>{{"fillHoles", "keepLargest", "removeSmall", "keepClicked",
            "removeClicked", "giveClicked"}},
        "holes are surrounded on all sides; islands do not touch each other, not even at a corner");
    visit.maybe("mm3", edit.mm3, editFields::Number{"mm³", 0.0, 1e9, quantum::perCubicMillimetre},
        "the largest hole that is filled, or the smallest island that stays",
        "every hole is filled");
    visit.maybe("islandLps", edit.islandLps, positionLps,
        "a place in the island that keepClicked, removeClicked and giveClicked are about, patient "
        "coordinates (LPS)",
        "the rule is about no single island");
    visit.maybe("to", edit.to, segmentNumber,
        "of giveClicked: the segment that receives the island; it must not be locked either",
        "no island is given away");
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<CombineSegments> = "combineSegments";
template <>
inline constexpr const char* editMeaning<CombineSegments> =
    "Gives a segment all voxels of another one, or exchanges theirs; neither is locked. Segments "
    "share no voxel, so there is nothing to copy, subtract or intersect.";
template <class Visitor> void visitFields(Visitor& visit, CombineSegments& edit)
{
    visitSegment(visit, edit.segment);
    visit.field("with", Presence::Required, edit.with, segmentNumber, "the other segment");
    visit.field("how", Presence::Required, edit.how,
        editFields::Choice<CombineSegments::How, 2>{{"merge", "swap"}},
        "the other's voxels become the segment's, and it stays in the list, empty; or each "
        "receives those of the other");
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
        "grow and shrink by a margin; hollow leaves a shell; open removes what no ball within the "
        "segment holds, close adds what no ball beside it holds; median gives each voxel to the "
        "side on which more than half of the ball around it lies, gaussian the same with a "
        "Gaussian; wrap adds holes and all that lies behind openings narrower than the ball");
    visit.field("mm", Presence::Required, edit.mm,
        editFields::Number{"mm", 0.01, 100.0, quantum::perMillimetre},
        "the margin, the thickness of the shell, the radius of the ball, or the standard deviation "
        "of the Gaussian");
    visit.maybe("shell", edit.shell,
        editFields::Choice<ShellPlace, 3>{{"inside", "centred", "outside"}},
        "of hollow alone: where the shell lies, from the segment's border", "inside");
    visit.maybe("with", edit.with, editFields::SegmentList{},
        "of gaussian alone: others, not locked either, that are smoothed together with it: each "
        "voxel that one of them or none has becomes the one's that is most around it, so that no "
        "gap opens between them",
        "it alone");
    const auto side = [&](const char* name, std::optional<double>& mm) {
        visit.maybe(name, mm, editFields::Number{"mm", 0.0, 100.0, quantum::perMillimetre},
            "of grow and shrink alone: the margin on this side of the patient; 0: none there",
            "as mm");
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
        "the segment becomes these voxels and loses all others, receives them, or loses them");
    visit.field("onlyVisible", Presence::Optional, edit.onlyVisible, editFields::Flag{},
        "whether voxels that are carved away stay as they are");
    visit.maybe("box", edit.box, editFields::CornerPair{positionLps},
        "two opposite corners: only voxels between them change", "the whole volume");
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
        "whether what is painted takes part in growth: the next one goes on from there");
    visit.maybe("edgeTolerance", edit.edgeTolerance,
        editFields::Number{"modality units", 0.0, quantum::unbounded, 0.0},
        "follow edges: only voxels whose values differ by at most this from the one where the "
        "path begins (the median of the voxels around it), and that are joined to the path by "
        "such voxels under the brush",
        "all that is under the brush");
    visitEditable(visit, edit.editable);
    visit.maybe("tool", edit.tool, editFields::Choice<PaintStroke::Tool, 1>{{"nudge"}},
        "nudge: a disc that pushes the border of the segment in one slice, outwards, or inwards "
        "with erase; it says so in the history and decides no voxel",
        "a brush");
    visit.maybe("toleranceByPressure", edit.toleranceByPressure, editFields::Flag{},
        "whether pressures are shares of edgeTolerance instead of the radius, which is whole then",
        "false");
}

template <> inline constexpr const char* editName<FillOutline> = "fillOutline";
template <>
inline constexpr const char* editMeaning<FillOutline> =
    "Gives a segment what lies inside a closed outline in one slice, along the grid or oblique and "
    "one voxel thick, or takes it away there.";
template <class Visitor> void visitFields(Visitor& visit, FillOutline& edit)
{
    constexpr editFields::Point direction{
        editFields::Number{"", -1000.0, 1000.0, quantum::perDirection}};
    visitSegment(visit, edit.segment);
    visit.field("originLps", Presence::Required, edit.originLps, positionLps,
        "a place in the slice, patient coordinates (LPS)");
    visit.field("rightLps", Presence::Required, edit.rightLps, direction,
        "a direction in the slice, patient coordinates (LPS)");
    visit.field("upLps", Presence::Required, edit.upLps, direction,
        "another one; only what is perpendicular to the first counts");
    visit.field("polygonMm", Presence::Required, edit.polygonMm,
        editFields::Outline{editFields::Number{"mm", -2000.0, 2000.0, quantum::perMillimetre}},
        "a closed curve in the slice, relative to the origin: right, up; inside is what it winds "
        "around, and the curve itself");
    visit.field("erase", Presence::Optional, edit.erase, editFields::Flag{},
        "whether voxels of the segment are taken away instead");
    visitOnlyValues(visit, edit.lower, edit.upper);
    visitOverwrite(visit, edit.overwriteUnlocked);
    visitEditable(visit, edit.editable);
}

/// The segment that receives voxels.
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

template <> inline constexpr const char* editName<LayerToSegment> = "layerToSegment";
template <>
inline constexpr const char* editMeaning<LayerToSegment> =
    "Gives what a sculpt layer has carved (coverage of one half and more) to a segment; does "
    "nothing where it takes no voxel.";
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
    "Gives what is seen, from wherever, to a segment: what no layer carves, inside the clip "
    "region, with values in an interval; does nothing where it takes no voxel.";
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
    "Takes in the segments of a mask's file; does nothing where they take no voxel. A row of the "
    "history holds their voxels and needs the file no more.";
template <class Visitor> void visitFields(Visitor& visit, ImportMask& edit)
{
    visit.field("file", Presence::Required, edit.file, editFields::FileName{},
        "labels in NIfTI, NRRD, .seg.nrrd or MetaImage, a DICOM SEG or RTSTRUCT, or a surface in "
        "STL, OBJ or PLY");
    visit.maybe("as", edit.as, editFields::SegmentReference{},
        "the segment that receives all of it: the number of one that is there, or the name of one "
        "that is there or else is made",
        "each segment of the file becomes a new one");
    visitOverwrite(visit, edit.overwriteUnlocked);
    visit.maybe("size", edit.size, editFields::GridSize{}, "of the volume that the voxels are of",
        "the file is read when the recipe is");
    visit.maybe("segments", edit.segments, editFields::ImportedSegmentList{},
        "what the file held, on the volume's grid: voxels are packed runs",
        "the file is read "
        "when the recipe is");
    visit.maybe("ahead", edit.ahead, editFields::EntryOrder{},
        "where segments overlap: which of them, by their places from 1 among those that are taken "
        "in, go before all others, the first one foremost",
        "the file's order");
    visit.maybe("planes", edit.planes, editFields::PlaneList{},
        "the label plane of each of them: those of different planes keep the voxels that they "
        "share, those of one plane do not",
        "where a file is read whose segments overlap and 'ahead' says nothing, as few planes as "
        "they need; else all lie in plane 0");
}

} // namespace core::editSchema
