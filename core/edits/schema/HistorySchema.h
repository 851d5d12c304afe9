// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/schema/SculptSchema.h"

namespace core::editSchema {

template <> inline constexpr const char* editName<RevertRows> = "revert";
template <>
inline constexpr const char* editMeaning<RevertRows> =
    "Undoes only these older strokes and growths, where nothing has written or read the same place "
    "since.";
template <class Visitor> void visitFields(Visitor& visit, RevertRows& edit)
{
    visit.field("rows", Presence::Required, edit.rows, editFields::RowList{},
        "the rows to undo, all of them before this one, in ascending order (burin history --json "
        "calls them seq)");
}

inline constexpr editFields::Number outlineFactor{"", 0.05, 20.0, 1024.0};

template <> inline constexpr const char* editName<ReviseStroke> = "reviseStroke";
template <>
inline constexpr const char* editMeaning<ReviseStroke> =
    "Changes or removes an older cut of drill, laser, peel, scissors or brush; what later strokes "
    "cut stays.";
template <class Visitor> void visitFields(Visitor& visit, ReviseStroke& edit)
{
    visit.field("row", Presence::Required, edit.row, editFields::Row{},
        "the row of the cut, which is before this one (burin history --json calls it "
        "seq)");
    visit.maybe("radiusMm", edit.radiusMm, drillRadius, "the new radius of a disc or brush");
    visit.maybe("sideMm", edit.sideMm, maskSide, "the new side of a square mask");
    visit.maybe("widthMm", edit.widthMm, maskSide,
        "the new width of a mask that is an ellipse, a rectangle or a rounded rectangle");
    visit.maybe("heightMm", edit.heightMm, maskSide,
        "the new height of a mask that is an ellipse, a rectangle or a rounded rectangle");
    visit.maybe("factor", edit.factor, outlineFactor,
        "how many times as large a drawn outline becomes: that of a mask about its sample, that of "
        "peel or scissors about its middle");
    visit.maybe("depthMm", edit.depthMm, drillDepth, "the new depth; a brush has none");
    visit.maybe("softnessMm", edit.softnessMm, maskSoftness,
        "the new width of the soft edge of a drill or laser");
    visit.maybe("layer", edit.layer, layerNumber, "the new sculpt layer");
    visit.maybe("throughGaps", edit.throughGaps, editFields::Flag{},
        "whether the cut goes on behind a gap in the material");
    visit.field("removed", Presence::Optional, edit.removed, editFields::Flag{},
        "whether the cut is removed altogether");
}

} // namespace core::editSchema
