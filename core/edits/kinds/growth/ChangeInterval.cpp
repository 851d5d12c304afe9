// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/ChangeInterval.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/criteria/GrowthParts.h"
#include "core/edits/kinds/growth/OpenGrowth.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/edits/open/StrokeExtension.h"

namespace core {

using namespace rowWords;

namespace {

/// A growth whose interval can be changed again while it is open (ToInterval): it then begins anew.
class OpenInterval final : public OpenGrowth {
public:
    explicit OpenInterval(ChangeInterval& change)
        : OpenGrowth(change.steps)
        , m_change(change)
    {
    }
    [[nodiscard]] Told begin(
        const EngineEdit& command, const Document& document, bool isWhole) override
    {
        m_hasBegun = true;
        return OpenGrowth::begin(command, document, isWhole);
    }
    [[nodiscard]] Result<Told> extend(
        const StrokeExtension& extension, const Document& document) override
    {
        const auto* to = std::get_if<ToInterval>(&extension);
        if (!to)
            return OpenGrowth::extend(extension, document);
        m_change.criteria.lower = to->lower;
        m_change.criteria.upper = to->upper;
        Told told;
        if (!m_hasBegun)
            return told;
        Result<GrowBurst> burst = growBurst(m_change, document);
        if (!burst)
            return tl::unexpected(burst.error());
        told.push_back(GrowAnew{*std::move(burst)});
        return told;
    }

private:
    ChangeInterval& m_change;
    bool m_hasBegun = false;
};

} // namespace

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
        .standsOpen = opens<ChangeInterval>(),
        .fills = fillsNothing,
        .boundToStudy = !edit.asBefore && namesPlaces(edit.criteria),
        .movesGenerationOf = growthPlaneOf(edit.criteria.plane)};
}

Result<GrowBurst> growBurst(const ChangeInterval& change, const Document& document)
{
    Result<GrowBurst> burst = burstOf(change.criteria, document, QStringLiteral("interval"));
    if (!burst)
        return burst;
    burst->opening = change.fromSeeds.value_or(false) ? GrowOpening::Restart : GrowOpening::Narrow;
    if (burst->opening == GrowOpening::Narrow && isAsked(burst->limits.passage))
        return failure(ErrorCode::InvalidField, QStringLiteral("interval.fromSeeds"),
            Clause::saying("must be true with a passage width"));
    burst->guard = guardRule(change.guard, document.volumes.front().geometry);
    return burst;
}

Result<EngineEdit> engineEdit(const ChangeInterval& edit, const Document& document)
{
    return engineEditFrom(growBurst(edit, document));
}

std::unique_ptr<OpenStroke> openStroke(ChangeInterval& edit)
{
    return std::make_unique<OpenInterval>(edit);
}

/// "Recover 120 … 300 HU, +2 104 voxels"; the name says what was done.
RowTitle rowTitle(const ChangeInterval& change, const RowFacts& row)
{
    const std::int64_t gained = row.facts.labelsGrown;
    const std::int64_t lost = row.facts.labelsLost;
    const TitleArgument interval = asArgument(intervalTitle(change.criteria, row.document));
    if (row.facts.empty())
        return {.code = RowTitleCode::Interval,
            .arguments = {interval},
            .then = {{.code = RowTitleCode::NoVoxel}}};
    return {.code = change.fromSeeds.value_or(false) ? RowTitleCode::GrowAnew
            : gained > 0 && lost > 0                 ? RowTitleCode::RecoverAndWithdraw
            : lost > 0                               ? RowTitleCode::WithdrawTo
                                                     : RowTitleCode::Recover,
        .arguments = {interval},
        .then = {gained > 0 || lost > 0
                ? flowTitle(gained, lost)
                : figure(RowTitleCode::SeedVoxels, row.facts.seedWordsChanged)}};
}

EditDependencies dependencies(const ChangeInterval& edit, const DependencyFacts& row)
{
    return growthDependencies(edit.criteria, row);
}

} // namespace core
