// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/schema/SculptSchema.h"

namespace core::editSchema {

template <> inline constexpr const char* editName<RevertRows> = "revert";
template <>
inline constexpr const char* editMeaning<RevertRows> =
    "Undoes older strokes and growths only, where nothing wrote or read the same place since.";
template <class Visitor> void visitFields(Visitor& visit, RevertRows& edit)
{
    visit.field("rows", Presence::Required, edit.rows, editFields::RowList{},
        "rows of the history before this one, ascending (burin history: seq)");
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
        "a cut of the history before this row (burin history: seq)");
    visit.maybe("radiusMm", edit.radiusMm, drillRadius, "another radius of a disc or brush");
    visit.maybe("sideMm", edit.sideMm, maskSide, "another side of a square mask");
    visit.maybe("widthMm", edit.widthMm, maskSide,
        "another width of a mask that is an ellipse, a rectangle or rounded");
    visit.maybe("heightMm", edit.heightMm, maskSide,
        "another height of a mask that is an ellipse, a rectangle or rounded");
    visit.maybe("factor", edit.factor, outlineFactor,
        "how many times as large a drawn outline is to be: a mask's about its sample, a peel's or "
        "scissors' about its middle");
    visit.maybe("depthMm", edit.depthMm, drillDepth, "another depth, not of a brush");
    visit.maybe(
        "softnessMm", edit.softnessMm, maskSoftness, "another soft edge, of a drill or laser");
    visit.maybe("layer", edit.layer, layerNumber, "another sculpt layer");
    visit.maybe("throughGaps", edit.throughGaps, editFields::Flag{},
        "whether it goes on behind a gap in the material");
    visit.field("removed", Presence::Optional, edit.removed, editFields::Flag{},
        "whether it is taken out altogether");
}

} // namespace core::editSchema
