// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/DropSurface.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/surface/parts/SurfaceParts.h"

namespace core {

Result<void> check(const DropSurface& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const DropSurface&, Document& document)
{
    const Result<bool> known = changeSurface(document, false);
    document.surface.reset();
    return known;
}

EditEffects effects(const DropSurface&)
{
    return surfaceEffects(false);
}

RowTitle rowTitle(const DropSurface&, const RowFacts&)
{
    return {.code = RowTitleCode::RemoveSurface};
}

EditDependencies dependencies(const DropSurface&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
