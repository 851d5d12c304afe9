// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/ShrinkAt.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/criteria/GrowthParts.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/edits/open/OpenStroke.h"
#include "core/edits/open/StrokeExtension.h"
#include "core/engine/EngineResult.h"

#include <cstdint>

namespace core {

using namespace rowWords;

namespace {

/// It is told up to how many steps to go on (ToSteps), as far as that is possible
/// (EditSession::growthProgress() tells how far it is), and never goes back. When it is done, the
/// edit says how far it came.
class OpenBackwards final : public OpenStroke {
public:
    explicit OpenBackwards(int& steps)
        : m_steps(steps)
    {
    }
    [[nodiscard]] OpenManner manner() const override
    {
        return {.withoutPen = true, .usualEnding = Ending::Commit};
    }
    /// It begins with the steps that it was begun with: as an extension more of them are no error
    /// where they would take everything.
    [[nodiscard]] Result<Told> extend(const StrokeExtension& extension, const Document&) override
    {
        Told told;
        if (const auto* to = std::get_if<ToSteps>(&extension); to && to->steps > 0)
            told.push_back(CutFurther{.steps = std::uint32_t(to->steps)});
        return told;
    }
    void carriedOut(const EngineResult& result, bool isWhole) override
    {
        if (!isWhole)
            m_steps = int(result.statistics.generations);
    }

private:
    int& m_steps;
};

} // namespace

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
        .standsOpen = opensIf<ShrinkAt>(edit.steps.has_value()),
        .fills = fillsNothing,
        .boundToStudy = true,
        .movesGenerationOf = growthPlaneOf(edit.plane)};
}

Result<CutGrowth> cutGrowth(const ShrinkAt& shrink, const Document& document)
{
    if (shrink.onlyHere && shrink.steps)
        return failure(ErrorCode::InvalidField, QStringLiteral("shrinkAt.steps"),
            Clause::saying("nothing but the points is taken with onlyHere"));
    const CutGrowth::How how = shrink.onlyHere ? CutGrowth::How::Here
        : shrink.steps                         ? CutGrowth::How::Backwards
                                               : CutGrowth::How::Subtree;
    Result<CutGrowth> command = cutAt({.pointsLps = shrink.pointsLps,
                                          .plane = shrink.plane,
                                          .edit = QStringLiteral("shrinkAt"),
                                          .pointsField = QStringLiteral("pointsLps")},
        how, document);
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

std::unique_ptr<OpenStroke> openStroke(ShrinkAt& edit)
{
    return edit.steps ? std::make_unique<OpenBackwards>(*edit.steps) : nullptr;
}

RowTitle rowTitle(const ShrinkAt& edit, const RowFacts& row)
{
    RowTitle title = edit.steps
        ? figure(RowTitleCode::ShrinkHereSteps, row.statistics.generations)
        : RowTitle{.code = edit.onlyHere ? RowTitleCode::ShrinkOnlyHere : RowTitleCode::ShrinkHere};
    title.then = {figure(RowTitleCode::VoxelsLost, row.statistics.voxelsChanged)};
    return title;
}

EditDependencies dependencies(const ShrinkAt& edit, const DependencyFacts&)
{
    return dependsOn::Plane{growthPlaneOf(edit.plane)};
}

} // namespace core
