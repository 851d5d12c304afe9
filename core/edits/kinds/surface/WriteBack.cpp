// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/WriteBack.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/surface/SurfaceParts.h"

namespace core {

using namespace rowWords;

Result<void> check(const WriteBack& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const WriteBack&, Document& document)
{
    if (const Result<bool> known = changeSurface(document, false); !known)
        return known;
    const Segment* segment = document.segment(document.surface->segment);
    if (segment->locked)
        return failure(ErrorCode::SegmentLocked, segment->name);
    document.surface->differs = false;
    document.surface->maskChanged = false;
    return true;
}

EditEffects effects(const WriteBack&)
{
    return {.task = EditTask::Surface,
        .standsOpen = false,
        .changes = DocumentChange::What::Surface,
        .fills = fillsNothing};
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
EditDependencies dependencies(const WriteBack&, const DependencyFacts&)
{
    return dependsOn::Plane{};
}

} // namespace core
