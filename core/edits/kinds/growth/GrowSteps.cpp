// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/GrowSteps.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/criteria/GrowthParts.h"
#include "core/edits/kinds/growth/OpenGrowth.h"
#include "core/edits/kinds/parts/GrowthPlane.h"

namespace core {

using namespace rowWords;

Result<void> check(const GrowSteps& edit, const Document& document)
{
    return discardValue(growBurst(edit, document));
}

Result<bool> apply(const GrowSteps&, Document&)
{
    return false;
}

EditEffects effects(const GrowSteps& edit)
{
    return {.task = engineTask<GrowSteps>(),
        .standsOpen = opens<GrowSteps>(),
        .fills = fillsNothing,
        .boundToStudy = namesPlaces(edit.criteria),
        .movesGenerationOf = growthPlaneOf(edit.criteria.plane)};
}

Result<GrowBurst> growBurst(const GrowSteps& grow, const Document& document)
{
    Result<GrowBurst> burst = burstOf(grow.criteria, document, QStringLiteral("grow"));
    if (!burst)
        return burst;
    if (!grow.tellsHeld && isAsked(burst->limits.passage))
        return failure(ErrorCode::InvalidField, QStringLiteral("grow.tellsHeld"),
            Clause::saying("must be true with a passage width"));
    burst->tellsHeld = grow.tellsHeld;
    burst->guard = guardRule(grow.guard, document.volumes.front().geometry);
    return burst;
}

Result<EngineEdit> engineEdit(const GrowSteps& edit, const Document& document)
{
    return engineEditFrom(growBurst(edit, document));
}

std::unique_ptr<OpenStroke> openStroke(GrowSteps& edit)
{
    return std::make_unique<OpenGrowth>(edit.steps);
}

int grownSteps(std::uint32_t first, const EditStatistics& statistics, const ChangeFacts& facts)
{
    // An admitted seed is a member of the generation of the opening.
    return statistics.generations - (facts.admittedSeedsAt(first + 1) ? 1 : 0);
}

RowTitle rowTitle(const GrowSteps& grow, const RowFacts& row)
{
    if (row.facts.empty())
        return {.code = RowTitleCode::GrowInterval,
            .arguments = {asArgument(intervalTitle(grow.criteria, row.document))},
            .then = {{.code = RowTitleCode::NoVoxel}}};
    const Growth* before = row.document.growth(growthPlaneOf(grow.criteria.plane));
    const TitleCount steps{grownSteps(before ? before->generation : 0, row.statistics, row.facts)};
    const GrownSegments grown = grownSegments(row.facts, row.document);
    RowTitle title{.code = RowTitleCode::GrowSteps,
        .arguments = {steps},
        .then = {figure(RowTitleCode::VoxelsGained, row.statistics.voxelsChanged)}};
    if (grown.count == 1) {
        title.code = RowTitleCode::GrowSegmentSteps;
        title.arguments = {steps, grown.name};
    } else if (grown.count > 1) {
        title.code = RowTitleCode::GrowSegmentsSteps;
        title.arguments = {steps, TitleCount{grown.count}};
    }
    return title;
}

EditDependencies dependencies(const GrowSteps& edit, const DependencyFacts& row)
{
    return growthDependencies(edit.criteria, row);
}

} // namespace core
