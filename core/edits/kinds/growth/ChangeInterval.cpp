// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/ChangeInterval.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/EditReach.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/GrowthParts.h"

namespace core {

using namespace rowWords;

Result<void> check(const ChangeInterval& edit, const Document& document)
{
    return discardValue(growBurst(edit, document));
}

Result<bool> apply(const ChangeInterval&, Document&)
{
    return false;
}

EditEffects effects(const ChangeInterval& edit)
{
    return {.task = engineTask<ChangeInterval>(),
        .standsOpen = true,
        .boundToStudy = !edit.asBefore && edit.criteria.box.has_value()};
}

Result<GrowBurst> growBurst(const ChangeInterval& change, const Document& document)
{
    Result<GrowBurst> burst = burstOf(change.criteria, document, QStringLiteral("interval"));
    if (!burst)
        return burst;
    burst->opening = change.fromSeeds.value_or(false) ? GrowOpening::Restart : GrowOpening::Narrow;
    if (burst->opening == GrowOpening::Narrow && isAsked(burst->limits.passage))
        return failure(ErrorCode::InvalidField, QStringLiteral("interval.fromSeeds"),
            QStringLiteral("must be true with a passage width"));
    burst->guard = guardRule(change.guard, document.volumes.front().geometry);
    return burst;
}

Result<EngineEdit> engineEdit(const ChangeInterval& edit, const Document& document)
{
    return engineEditFrom(growBurst(edit, document));
}

/// "Recover 120 … 300 HU, +2 104 voxels"; the name says what was done.
QString rowName(const ChangeInterval& change, const RowFacts& row)
{
    const std::int64_t gained = row.facts.labelsGrown;
    const std::int64_t lost = row.facts.labelsLost;
    const QString what = change.fromSeeds.value_or(false) ? QStringLiteral("Grow anew from seeds")
        : gained > 0 && lost > 0                          ? QStringLiteral("Recover and withdraw")
        : lost > 0                                        ? QStringLiteral("Withdraw to")
                                                          : QStringLiteral("Recover");
    QStringList figures;
    if (gained > 0)
        figures += QLatin1Char('+') + grouped(gained);
    if (lost > 0)
        figures += QStringLiteral("−") + grouped(lost);
    if (row.facts.empty())
        return QStringLiteral("Interval %1, no voxel")
            .arg(intervalText(change.criteria, row.document));
    return QStringLiteral("%1 %2, %3")
        .arg(what, intervalText(change.criteria, row.document),
            figures.isEmpty() ? counted(row.facts.seedWordsChanged, "seed voxel")
                              : figures.join(QLatin1Char(' ')) + QStringLiteral(" voxels"));
}

EditReach reach(const ChangeInterval& edit, const ReachFacts& row)
{
    return reachOfGrowth(edit.criteria, row);
}

} // namespace core
