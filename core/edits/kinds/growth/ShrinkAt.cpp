// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/ShrinkAt.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/GrowthParts.h"

namespace core {

using namespace rowWords;

Result<void> check(const ShrinkAt& edit, const Document& document)
{
    return discardValue(cutGrowth(edit, document));
}

Result<bool> apply(const ShrinkAt&, Document&)
{
    return false;
}

EditEffects effects(const ShrinkAt&)
{
    return {.task = engineTask<ShrinkAt>(), .standsOpen = false, .boundToStudy = true};
}

Result<CutGrowth> cutGrowth(const ShrinkAt& shrink, const Document& document)
{
    Result<CutGrowth> command =
        cutAt(shrink.pointsLps, shrink.onlyHere ? CutGrowth::How::Here : CutGrowth::How::Subtree,
            document, QStringLiteral("shrinkAt.pointsLps"));
    if (command)
        command->barrier = shrink.barrier;
    return command;
}

Result<EngineEdit> engineEdit(const ShrinkAt& edit, const Document& document)
{
    return engineEditFrom(cutGrowth(edit, document));
}

RowTitle rowTitle(const ShrinkAt& edit, const RowFacts& row)
{
    return {.code = edit.onlyHere ? RowTitleCode::ShrinkOnlyHere : RowTitleCode::ShrinkHere,
        .then = {figure(RowTitleCode::VoxelsLost, row.statistics.voxelsChanged)}};
}

EditDependencies dependencies(const ShrinkAt&, const DependencyFacts& row)
{
    return row.wholeGrowth();
}

} // namespace core
