// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/FollowMask.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/surface/parts/SurfaceParts.h"

namespace core {

using namespace rowWords;

Result<void> check(const FollowMask& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const FollowMask&, Document& document)
{
    return changeSurface(document, true);
}

EditEffects effects(const FollowMask&)
{
    return surfaceEffects(false);
}

RowTitle rowTitle(const FollowMask&, const RowFacts& row)
{
    return {.code = RowTitleCode::FollowMask,
        .then = {figure(RowTitleCode::Vertices, row.statistics.verticesChanged)}};
}

EditDependencies dependencies(const FollowMask&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
