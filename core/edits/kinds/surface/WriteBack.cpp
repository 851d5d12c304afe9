// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/WriteBack.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/kinds/surface/parts/SurfaceParts.h"

namespace core {

using namespace rowWords;

bool agreesAfterwards(const WriteBack& edit)
{
    return !isLimited(edit.editable);
}

Result<void> check(const WriteBack& edit, const Document& document)
{
    if (const auto editable = editableVoxels(edit.editable, document, "writeBack"); !editable)
        return tl::unexpected(editable.error());
    return checkApplied(edit, document);
}

Result<bool> apply(const WriteBack& edit, Document& document)
{
    if (const Result<bool> known = changeSurface(document, false); !known)
        return known;
    const Segment* segment = document.segment(document.surface->segment);
    if (segment->locked)
        return failure(ErrorCode::SegmentLocked, segment->name);
    if (!agreesAfterwards(edit))
        return false;
    document.surface->differs = false;
    document.surface->maskChanged = false;
    return true;
}

EditEffects effects(const WriteBack& edit)
{
    return {.task = EditTask::Surface,
        .standsOpen = false,
        .changes = DocumentChange::What::Surface,
        .fills = fillsNothing,
        .boundToStudy = namesPlaces(edit.editable)};
}

RowTitle rowTitle(const WriteBack&, const RowFacts& row)
{
    return {.code = RowTitleCode::WriteBack,
        .arguments = {row.document.surface
                ? segmentName(row.document.surface->segment, row.document)
                : QString()},
        .then = {figure(RowTitleCode::Voxels, row.statistics.voxelsChanged)}};
}

/// In all planes: the surface that says in which its segment lies may be another one by now.
EditDependencies dependencies(const WriteBack& edit, const DependencyFacts& row)
{
    return row.alsoReading(edit.editable, dependsOn::Plane{});
}

} // namespace core
