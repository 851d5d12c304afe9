// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

/// In the order of SliceAxis.
inline constexpr editFields::Choice<SliceAxis, 3> sliceAxisNames{{"i", "j", "k"}};

template <> inline constexpr const char* editName<FillBetweenSlices> = "fillBetweenSlices";
template <>
inline constexpr const char* editMeaning<FillBetweenSlices> =
    "Gives a segment that is not locked and was drawn on some slices what lies between them, by "
    "shape-based interpolation. Takes only voxels that no segment has; does nothing where no "
    "slice between drawn ones is empty.";
template <class Visitor> void visitFields(Visitor& visit, FillBetweenSlices& edit)
{
    visitSegment(visit, edit.segment);
    visit.maybe("axis", edit.axis, sliceAxisNames,
        "the index axis across the slices: i for columns, j for rows, k for the acquired slices",
        "the one across which the smallest share of slices has voxels of the segment");
    visitEditable(visit, edit.editable);
}

template <> inline constexpr const char* editName<FloodFill> = "floodFill";
template <>
inline constexpr const char* editMeaning<FloodFill> =
    "Gives a segment what hangs together with a place and differs in value from it by no more than "
    "a tolerance, or takes away what hangs together of the segment there; within a slice or in all "
    "directions.";
template <class Visitor> void visitFields(Visitor& visit, FloodFill& edit)
{
    visitSegment(visit, edit.segment);
    visit.field("placeLps", Presence::Required, edit.placeLps, positionLps,
        "a place in the voxel with which it begins, patient coordinates (LPS)");
    visit.maybe("within", edit.within, sliceAxisNames,
        "only in the slice across this index axis: i for columns, j for rows, k for the acquired "
        "slices",
        "in all directions");
    visit.field("corners", Presence::Optional, edit.corners, editFields::Flag{},
        "whether voxels also hang together at an edge or a corner");
    visit.field("erase", Presence::Optional, edit.erase, editFields::Flag{},
        "whether what hangs together of the segment is taken away instead");
    visit.when(!edit.erase, [&] {
        visit.field("tolerance", Presence::Required, edit.tolerance,
            editFields::Number{"modality units", 0.0, quantum::unbounded},
            "how far values may differ from the one at the place (not to erase)");
        visitOverwrite(visit, edit.overwriteUnlocked);
    });
    visitEditable(visit, edit.editable);
}

} // namespace core::editSchema
