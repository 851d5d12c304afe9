// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/splitting/CopySegment.h"
#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/edits/schema/EditSplits.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

template <> inline constexpr const char* editName<SplitIslands> = "splitIslands";
template <>
inline constexpr const char* editMeaning<SplitIslands> =
    "Makes new segments of the islands of a segment that is not locked, from the second largest "
    "down; the largest stays the segment's. Does nothing where there is no other.";
template <class Visitor> void visitFields(Visitor& visit, SplitIslands& edit)
{
    visitSegment(visit, edit.segment);
    visit.maybe("mm3", edit.mm3, editFields::Number{"mm³", 0.0, 1e9, quantum::perCubicMillimetre},
        "the smallest island that becomes a segment; smaller ones stay with the largest",
        "every island becomes one");
    visit.maybe("into", edit.into, editFields::SplitPartList{},
        "the new segments, from the largest island down; further islands stay with the largest; a "
        "row of the history always has this list",
        "one for each island, named after the segment");
    visitEditable(visit, edit.editable);
}

/// The new segment of an edit that makes one.
template <class Visitor> void visitPart(Visitor& visit, SplitPart& part)
{
    visit.field(
        "name", Presence::Required, part.name, editFields::Text{}, "the name of the new segment");
    visit.field("color", Presence::Required, part.rgb, editFields::Colour{},
        "the colour of the new segment");
}

template <> inline constexpr const char* editName<SplitSegment> = "splitSegment";
template <>
inline constexpr const char* editMeaning<SplitSegment> =
    "Splits a segment that is not locked by a plane: what lies beyond it becomes a new segment. "
    "Does nothing where all of it lies on one side.";
template <class Visitor> void visitFields(Visitor& visit, SplitSegment& edit)
{
    visitSegment(visit, edit.segment);
    visit.field("placeLps", Presence::Required, edit.placeLps, positionLps,
        "a place in the plane, in patient coordinates (LPS)");
    visit.field("normalLps", Presence::Required, edit.normalLps,
        editFields::Point{editFields::Number{"", -1000.0, 1000.0, quantum::perDirection}},
        "the direction across the plane in which the new segment lies");
    visitPart(visit, edit.into);
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<SplitByCurve> = "splitByCurve";
template <>
inline constexpr const char* editMeaning<SplitByCurve> =
    "Splits a segment that is not locked by a curve, along the view: what lies on one side of it "
    "becomes a new segment. Does nothing where one side would have all of it.";
template <class Visitor> void visitFields(Visitor& visit, SplitByCurve& edit)
{
    visitSegment(visit, edit.segment);
    visitView(visit, edit.view);
    visit.field("open", Presence::Optional, edit.open, editFields::Flag{},
        "whether the curve is a line that goes on straight at both ends; otherwise it closes");
    visit.field("curveMm", Presence::Required, edit.curveMm, edit.open ? viewLine : viewOutline,
        "a curve in the view plane, as points to the right and up from the target");
    visit.field("side", Presence::Optional, edit.side,
        editFields::Choice<SplitByCurve::Side, 4>{{"inside", "outside", "smaller", "larger"}},
        "where the new segment lies: inside or outside of the curve, where fewer voxels of the "
        "segment lie, or where more do; inside of an open curve is what lies on its left");
    visit.when(edit.side == SplitByCurve::Side::Inside, [&] {
        visit.maybe("depthMm", edit.depthMm, drillDepth,
            "how far the new segment reaches behind what each line of sight meets first of the "
            "segment; only given with the side inside",
            "through everything");
    });
    visitPart(visit, edit.into);
    visitHidden(visit, edit.hidden);
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<CopySegment> = "copySegment";
template <>
inline constexpr const char* editMeaning<CopySegment> =
    "Makes a new segment with the voxels and the code of a segment, which stays as it is and may "
    "be locked; the copy lies in another label plane, so that both have these voxels. Does nothing "
    "if it takes no voxel.";
template <class Visitor> void visitFields(Visitor& visit, CopySegment& edit)
{
    visitSegment(visit, edit.segment);
    visitName(visit, edit.name);
    visit.field("color", Presence::Required, edit.rgb, editFields::Colour{}, "the display colour");
    visit.maybe("plane", edit.plane, labelPlane,
        "the label plane of the copy, not the segment's; what other segments have there is left "
        "out; a row of the history always names it",
        "the first one with segments in which all voxels of the segment are free, or else the "
        "first one without segments; refused if there is neither");
    visitEditable(visit, edit.editable);
}

} // namespace core::editSchema
