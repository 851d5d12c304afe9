// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/GrowSteps.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/EditReach.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/GrowthParts.h"

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
        .standsOpen = true,
        .boundToStudy = edit.criteria.box.has_value()};
}

Result<GrowBurst> growBurst(const GrowSteps& grow, const Document& document)
{
    Result<GrowBurst> burst = burstOf(grow.criteria, document, QStringLiteral("grow"));
    if (!burst)
        return burst;
    if (!grow.tellsHeld && isAsked(burst->limits.passage))
        return failure(ErrorCode::InvalidField, QStringLiteral("grow.tellsHeld"),
            QStringLiteral("must be true with a passage width"));
    burst->tellsHeld = grow.tellsHeld;
    burst->guard = guardRule(grow.guard, document.volumes.front().geometry);
    return burst;
}

Result<EngineEdit> engineEdit(const GrowSteps& edit, const Document& document)
{
    return engineEditFrom(growBurst(edit, document));
}

int grownSteps(std::uint32_t first, const EditStatistics& statistics, const ChangeFacts& facts)
{
    // An admitted seed is a member of the generation of the opening.
    return statistics.generations - (facts.admittedSeedsAt(first + 1) ? 1 : 0);
}

QString rowName(const GrowSteps& grow, const RowFacts& row)
{
    if (row.facts.empty())
        return QStringLiteral("Grow %1, no voxel").arg(intervalText(grow.criteria, row.document));
    const Growth* before = row.document.growth(0);
    const int steps = grownSteps(before ? before->generation : 0, row.statistics, row.facts);
    return QStringLiteral("Grow %1%2, +%3")
        .arg(whatGrew(row.facts, row.document), counted(steps, "step"),
            counted(row.statistics.voxelsChanged, "voxel"));
}

EditReach reach(const GrowSteps& edit, const ReachFacts& row)
{
    return reachOfGrowth(edit.criteria, row);
}

} // namespace core
