// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/schema/EditChunks.h"
#include "core/edits/schema/EditMasks.h"
#include "core/edits/schema/SchemaParts.h"

namespace core::editSchema {

template <> inline constexpr const char* editName<DivideSegment> = "chunks";
template <>
inline constexpr const char* editMeaning<DivideSegment> =
    "Divides a segment and what lies around it into chunks of different likelihood, which "
    "chunkToggle adds and takes. Changes no voxel. A row of the history holds the labels that the "
    "chunks depend on.";
template <class Visitor> void visitFields(Visitor& visit, DivideSegment& edit)
{
    visitSegment(visit, edit.segment);
    visit.field("marginMm", Presence::Optional, edit.marginMm,
        editFields::Number{"mm", 0.0, 500.0, quantum::perMillimetre},
        "how far the division reaches beyond the segment's voxels, on all sides");
    visit.maybe("owners", edit.owners, editFields::ChunkOwnerList{},
        "the labels that were in the box, on the volume's grid, with voxels as packed runs",
        "the labels at the time when the edit is carried out");
    visit.maybe("probabilities", edit.probabilities, editFields::PackedBytes{},
        "a probability map of the segment, packed, with one byte for each voxel of the volume",
        "none");
    visit.maybe("probabilityFile", edit.probabilityFile, editFields::FileName{},
        "the file of a probability map of the segment, which also decides what is likely: numbers "
        "from 0 to 1, or bytes, in NIfTI, NRRD or MetaImage, or a DICOM SEG of type FRACTIONAL "
        "with one segment; it "
        "is read when the recipe is",
        "the image alone decides");
}

template <> inline constexpr const char* editName<ChunkToggle> = "chunkToggle";
template <>
inline constexpr const char* editMeaning<ChunkToggle> =
    "Adds chunks of the newest division to a segment, or takes them away; does nothing where no "
    "chunk is hit.";
template <class Visitor> void visitFields(Visitor& visit, ChunkToggle& edit)
{
    using Mode = ChunkToggle::Mode;
    visitSegment(visit, edit.segment);
    visit.field("chunks", Presence::Required, edit.chunks, editFields::WholeNumber{1, 5000},
        "into how many chunks the whole is divided; never more than there are, nor fewer than "
        "there are separate parts");
    visit.field("mode", Presence::Optional, edit.mode,
        editFields::Choice<Mode, 3>{{"toggle", "add", "remove"}},
        "what happens to the chunks; toggle takes a chunk away if the segment has more than half "
        "of it, and otherwise adds it");
    visit.field("pointsLps", Presence::Required, edit.pointsLps, editFields::PointList{positionLps},
        "points that each stand for the chunk in which they lie, in patient coordinates (LPS)");
    visitOverwrite(visit, edit.overwriteUnlocked);
    visit.maybe("bricks", edit.bricks, editFields::BrickList{},
        "the bricks of the volume in which the chunks lie",
        "they are found when it is carried out");
    visitEditable(visit, edit.editable);
}

} // namespace core::editSchema
