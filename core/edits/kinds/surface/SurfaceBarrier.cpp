// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/SurfaceBarrier.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/surface/parts/SurfaceParts.h"

namespace core {

using namespace rowWords;

Result<void> check(const SurfaceBarrier& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const SurfaceBarrier&, Document& document)
{
    const Result<bool> known = changeSurface(document, false);
    return known ? Result<bool>(false) : known;
}

EditEffects effects(const SurfaceBarrier&)
{
    return {.task = EditTask::Surface, .standsOpen = false, .fills = fillsNothing};
}

RowTitle rowTitle(const SurfaceBarrier& edit, const RowFacts& row)
{
    return {.code = edit.erase ? RowTitleCode::OpenBarrierAroundSurface
                               : RowTitleCode::BarrierAroundSurface,
        .then = {figure(RowTitleCode::Voxels, row.facts.seedWordsChanged)}};
}

/// In all planes, as for WriteBack.
EditDependencies dependencies(const SurfaceBarrier&, const DependencyFacts&)
{
    return dependsOn::Plane{};
}

} // namespace core
