// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/ShrinkSteps.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/GrowthParts.h"
#include "core/growth/SeedWord.h"

namespace core {

using namespace rowWords;

Result<void> check(const ShrinkSteps& edit, const Document& document)
{
    return discardValue(shrinkGrowth(edit, document));
}

Result<bool> apply(const ShrinkSteps&, Document&)
{
    return false;
}

EditEffects effects(const ShrinkSteps&)
{
    return {.task = engineTask<ShrinkSteps>(), .standsOpen = true, .movesGeneration = true};
}

Result<ShrinkGrowth> shrinkGrowth(const ShrinkSteps& shrink, const Document& document)
{
    constexpr std::uint8_t plane = 0;
    ShrinkGrowth command{.plane = plane};
    if (const Growth* growth = document.growth(plane))
        command.generation = growth->generation;
    // The accepted seeds are the first generation.
    const std::uint32_t steps = std::uint32_t(shrink.steps.value_or(int(seedWord::maxGeneration)));
    command.keepSeeds = steps >= command.generation;
    command.keep = command.keepSeeds ? 0 : command.generation - steps;
    command.lockedLabels = document.lockedLabels(plane);
    if (nothingMayChange(document, plane))
        return failure(ErrorCode::SegmentLocked, QString());
    return command;
}

Result<EngineEdit> engineEdit(const ShrinkSteps& edit, const Document& document)
{
    return engineEditFrom(shrinkGrowth(edit, document));
}

RowTitle rowTitle(const ShrinkSteps& edit, const RowFacts& row)
{
    RowTitle title = edit.steps ? figure(RowTitleCode::ShrinkSteps, row.statistics.generations)
                                : RowTitle{.code = RowTitleCode::ShrinkToSeeds};
    title.then = {figure(RowTitleCode::VoxelsLost, row.statistics.voxelsChanged)};
    return title;
}

EditDependencies dependencies(const ShrinkSteps&, const DependencyFacts& row)
{
    return row.wholeGrowth();
}

} // namespace core
