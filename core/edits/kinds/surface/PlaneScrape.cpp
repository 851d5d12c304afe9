// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/PlaneScrape.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/surface/parts/SurfaceParts.h"

namespace core {

Result<void> check(const PlaneScrape& edit, const Document& document)
{
    if (const Result<void> pressed = checkPressures(edit.path, "planeScrape"); !pressed)
        return pressed;
    return checkApplied(edit, document);
}

Result<bool> apply(const PlaneScrape& edit, Document& document)
{
    if (edit.normalLps == glm::dvec3(0.0))
        return failure(ErrorCode::InvalidField, QStringLiteral("planeScrape.normalLps"),
            Clause::saying("has no direction"));
    return changeSurface(document, true);
}

EditEffects effects(const PlaneScrape&)
{
    return surfaceEffects(opens<PlaneScrape>());
}

RowTitle rowTitle(const PlaneScrape& scrape, const RowFacts& row)
{
    return strokeTitle(RowTitleCode::Scrape, scrape.path, row.statistics);
}

EditDependencies dependencies(const PlaneScrape&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
