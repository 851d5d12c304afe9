// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/PlugLeak.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/criteria/GrowthParts.h"
#include "core/edits/kinds/parts/GrowthPlane.h"

namespace core {

using namespace rowWords;

Result<void> check(const PlugLeak& edit, const Document& document)
{
    return discardValue(cutGrowth(edit, document));
}

Result<bool> apply(const PlugLeak&, Document&)
{
    return false;
}

EditEffects effects(const PlugLeak& edit)
{
    return {.task = engineTask<PlugLeak>(),
        .standsOpen = false,
        .fills = fillsNothing,
        .boundToStudy = true,
        .movesGenerationOf = growthPlaneOf(edit.plane)};
}

Result<CutGrowth> cutGrowth(const PlugLeak& plug, const Document& document)
{
    return cutAt({.pointsLps = {plug.pointLps},
                     .plane = plug.plane,
                     .edit = QStringLiteral("plug"),
                     .pointsField = QStringLiteral("pointLps")},
        CutGrowth::How::Neck, document);
}

Result<EngineEdit> engineEdit(const PlugLeak& edit, const Document& document)
{
    return engineEditFrom(cutGrowth(edit, document));
}

RowTitle rowTitle(const PlugLeak&, const RowFacts& row)
{
    return {.code = RowTitleCode::PlugLeak,
        .then = {figure(RowTitleCode::VoxelsLost, row.statistics.voxelsChanged)}};
}

EditDependencies dependencies(const PlugLeak& edit, const DependencyFacts&)
{
    return dependsOn::Plane{growthPlaneOf(edit.plane)};
}

} // namespace core
