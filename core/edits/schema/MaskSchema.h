// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/segments/ImportMask.h"
#include "core/edits/schema/EditMasks.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

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
    visit.field("overwriteUnlocked", Presence::Optional, edit.overwriteUnlocked, editFields::Flag{},
        "whether voxels of other segments that are not locked are taken");
    visit.maybe("size", edit.size, editFields::GridSize{}, "of the volume that the voxels are of",
        "the file is read when the recipe is");
    visit.maybe("segments", edit.segments, editFields::ImportedSegmentList{},
        "what the file held, on the volume's grid: voxels are packed runs",
        "the file is read "
        "when the recipe is");
}

} // namespace core::editSchema
