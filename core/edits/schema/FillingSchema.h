// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/filling/FillBetweenSlices.h"
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
}

} // namespace core::editSchema
