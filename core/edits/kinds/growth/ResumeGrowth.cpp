// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/ResumeGrowth.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/OpenGrowth.h"
#include "core/edits/kinds/parts/GrowthPlane.h"

namespace core {

/// It reads the history, not the document.
Result<void> check(const ResumeGrowth&, const Document&)
{
    return {};
}

Result<bool> apply(const ResumeGrowth&, Document&)
{
    return false;
}

EditEffects effects(const ResumeGrowth& edit)
{
    return {.task = engineTask<ResumeGrowth>(),
        .standsOpen = opens<ResumeGrowth>(),
        .fills = fillsNothing,
        .movesGenerationOf = growthPlaneOf(edit.plane)};
}

Result<EngineEdit> engineEdit(const ResumeGrowth&, const Document&)
{
    return failure(ErrorCode::InvalidField, QStringLiteral("resume"),
        Clause::saying("no growth was named that it goes on with"));
}

std::unique_ptr<OpenStroke> openStroke(ResumeGrowth& edit)
{
    return std::make_unique<OpenGrowth>(edit.steps);
}

/// It is kept as the growth that it was.
RowTitle rowTitle(const ResumeGrowth& edit, const RowFacts& row)
{
    return rowTitle(GrowSteps{.criteria = {.plane = edit.plane}, .steps = edit.steps}, row);
}

EditDependencies dependencies(const ResumeGrowth& edit, const DependencyFacts&)
{
    return dependsOn::Plane{growthPlaneOf(edit.plane)};
}

} // namespace core
