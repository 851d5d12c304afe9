// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/MarkSurface.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/surface/parts/SurfaceParts.h"

namespace core {

using namespace rowWords;

Result<void> check(const MarkSurface& edit, const Document& document)
{
    if (const Result<void> pressed = checkPressures(edit.path, "mark"); !pressed)
        return pressed;
    return checkApplied(edit, document);
}

Result<bool> apply(const MarkSurface&, Document& document)
{
    return changeSurface(document, false);
}

EditEffects effects(const MarkSurface&)
{
    return surfaceEffects(opens<MarkSurface>());
}

RowTitle rowTitle(const MarkSurface& mark, const RowFacts& row)
{
    return {.code = RowTitleCode::Mark,
        .arguments = {asArgument(markTitle(mark.mark))},
        .then = {{.code = RowTitleCode::MarkBrush, .arguments = {inMm(mark.path.radiusMm)}},
            figure(RowTitleCode::Vertices, row.statistics.verticesChanged)}};
}

EditDependencies dependencies(const MarkSurface&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
