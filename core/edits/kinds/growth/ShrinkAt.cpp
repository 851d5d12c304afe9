// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/ShrinkAt.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/GrowthParts.h"

#include <cstdint>

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

EditEffects effects(const ShrinkAt& edit)
{
    // Backwards it goes as long as it is held.
    return {.task = engineTask<ShrinkAt>(),
        .standsOpen = edit.steps.has_value(),
        .boundToStudy = true,
        .movesGeneration = true};
}

Result<CutGrowth> cutGrowth(const ShrinkAt& shrink, const Document& document)
{
    if (shrink.onlyHere && shrink.steps)
        return failure(ErrorCode::InvalidField, QStringLiteral("shrinkAt.steps"),
            Clause::saying("nothing but the points is taken with onlyHere"));
    const CutGrowth::How how = shrink.onlyHere ? CutGrowth::How::Here
        : shrink.steps                         ? CutGrowth::How::Backwards
                                               : CutGrowth::How::Subtree;
    Result<CutGrowth> command =
        cutAt(shrink.pointsLps, how, document, QStringLiteral("shrinkAt.pointsLps"));
    if (!command)
        return command;
    command->barrier = shrink.barrier;
    command->steps = std::uint32_t(shrink.steps.value_or(1));
    return command;
}

Result<EngineEdit> engineEdit(const ShrinkAt& edit, const Document& document)
{
    return engineEditFrom(cutGrowth(edit, document));
}

RowTitle rowTitle(const ShrinkAt& edit, const RowFacts& row)
{
    RowTitle title = edit.steps
        ? figure(RowTitleCode::ShrinkHereSteps, row.statistics.generations)
        : RowTitle{.code = edit.onlyHere ? RowTitleCode::ShrinkOnlyHere : RowTitleCode::ShrinkHere};
    title.then = {figure(RowTitleCode::VoxelsLost, row.statistics.voxelsChanged)};
    return title;
}

EditDependencies dependencies(const ShrinkAt&, const DependencyFacts& row)
{
    return row.wholeGrowth();
}

} // namespace core
