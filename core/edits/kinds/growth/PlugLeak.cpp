// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/PlugLeak.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/GrowthParts.h"

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

EditEffects effects(const PlugLeak&)
{
    return {.task = engineTask<PlugLeak>(),
        .standsOpen = false,
        .fills = fillsNothing,
        .boundToStudy = true,
        .movesGeneration = true};
}

Result<CutGrowth> cutGrowth(const PlugLeak& plug, const Document& document)
{
    return cutAt({plug.pointLps}, CutGrowth::How::Neck, document, QStringLiteral("plug.pointLps"));
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

EditDependencies dependencies(const PlugLeak&, const DependencyFacts& row)
{
    return row.wholeGrowth();
}

} // namespace core
