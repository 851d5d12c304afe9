// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/ShrinkSteps.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/criteria/GrowthParts.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/edits/open/OpenStroke.h"
#include "core/edits/open/StrokeExtension.h"
#include "core/growth/SeedWord.h"

#include <algorithm>
#include <cstdint>

namespace core {

using namespace rowWords;

namespace {

/// Another number of steps (ToSteps) replaces the earlier one, so that it goes back and forth. More
/// than there are: back to the seeds.
class OpenShrink final : public OpenStroke {
public:
    explicit OpenShrink(ShrinkSteps& shrink)
        : m_shrink(shrink)
    {
    }
    [[nodiscard]] OpenManner manner() const override
    {
        return {.withoutPen = true, .usualEnding = Ending::Commit};
    }
    [[nodiscard]] Told begin(const EngineEdit& command, const Document&, bool) override
    {
        m_first = std::get<ShrinkGrowth>(command).generation;
        return {};
    }
    [[nodiscard]] Result<Told> extend(const StrokeExtension& extension, const Document&) override
    {
        Told told;
        const auto* to = std::get_if<ToSteps>(&extension);
        if (!to)
            return told;
        m_shrink.steps = to->steps;
        if (m_first)
            told.push_back(
                ShrinkTo{.keep = *m_first - std::min(std::uint32_t(to->steps), *m_first)});
        return told;
    }

private:
    ShrinkSteps& m_shrink;
    std::optional<std::uint32_t> m_first; ///< the generation with which it began
};

} // namespace

Result<void> check(const ShrinkSteps& edit, const Document& document)
{
    return discardValue(shrinkGrowth(edit, document));
}

Result<bool> apply(const ShrinkSteps&, Document&)
{
    return false;
}

EditEffects effects(const ShrinkSteps& edit)
{
    return {.task = engineTask<ShrinkSteps>(),
        .standsOpen = opens<ShrinkSteps>(),
        .fills = fillsNothing,
        .movesGenerationOf = growthPlaneOf(edit.plane)};
}

Result<ShrinkGrowth> shrinkGrowth(const ShrinkSteps& shrink, const Document& document)
{
    const Result<std::uint8_t> named =
        growthPlane(shrink.plane, document, QStringLiteral("shrink"));
    if (!named)
        return tl::unexpected(named.error());
    const std::uint8_t plane = *named;
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

std::unique_ptr<OpenStroke> openStroke(ShrinkSteps& edit)
{
    return std::make_unique<OpenShrink>(edit);
}

RowTitle rowTitle(const ShrinkSteps& edit, const RowFacts& row)
{
    RowTitle title = edit.steps ? figure(RowTitleCode::ShrinkSteps, row.statistics.generations)
                                : RowTitle{.code = RowTitleCode::ShrinkToSeeds};
    title.then = {figure(RowTitleCode::VoxelsLost, row.statistics.voxelsChanged)};
    return title;
}

EditDependencies dependencies(const ShrinkSteps& edit, const DependencyFacts&)
{
    return dependsOn::Plane{growthPlaneOf(edit.plane)};
}

} // namespace core
