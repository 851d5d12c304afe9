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
        "how far around its voxels, on all sides");
    visit.maybe("owners", edit.owners, editFields::ChunkOwnerList{},
        "the labels there were in the box, on the volume's grid: voxels are packed runs",
        "those that there are when it is carried out");
    visit.maybe("probabilities", edit.probabilities, editFields::PackedBytes{},
        "a probability map of the segment, packed: a byte a voxel of the volume", "none");
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
        "into how many chunks the whole is divided; as many as there are at most, and no fewer "
        "than hang together");
    visit.field("mode", Presence::Optional, edit.mode,
        editFields::Choice<Mode, 3>{{"toggle", "add", "remove"}},
        "what becomes of them; toggled, a chunk goes if the segment has more than half of it");
    visit.field("pointsLps", Presence::Required, edit.pointsLps, editFields::PointList{positionLps},
        "each stands for the chunk it lies in, patient coordinates (LPS)");
    visitOverwrite(visit, edit.overwriteUnlocked);
    visit.maybe("bricks", edit.bricks, editFields::BrickList{},
        "those of the volume that the chunks lie in", "they are found when it is carried out");
}

} // namespace core::editSchema
