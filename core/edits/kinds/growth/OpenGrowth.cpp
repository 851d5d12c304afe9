// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/OpenGrowth.h"

#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/open/StrokeExtension.h"
#include "core/engine/EngineEdit.h"
#include "core/engine/EngineResult.h"

#include <cstdint>

namespace core {

OpenGrowth::OpenGrowth(std::optional<int>& steps)
    : m_steps(steps)
{
}

OpenManner OpenGrowth::manner() const
{
    return {.withoutPen = true, .usualEnding = Ending::Commit};
}

OpenStroke::Told OpenGrowth::begin(const EngineEdit&, const Document&, bool isWhole)
{
    Told told;
    if (isWhole && m_steps.value_or(1) > 0)
        told.push_back(GrowAdvance{.steps = m_steps.value_or(GrowAdvance::toClosure)});
    return told;
}

Result<OpenStroke::Told> OpenGrowth::extend(const StrokeExtension& extension, const Document&)
{
    Told told;
    if (const auto* advance = std::get_if<GrowAdvance>(&extension))
        told.push_back(*advance);
    else if (std::holds_alternative<PauseGrowth>(extension))
        told.push_back(GrowPause{});
    return told;
}

void OpenGrowth::carriedOut(const EngineResult& result, bool isWhole)
{
    if (isWhole && !result.alarm)
        return;
    m_steps.reset();
    if (!result.atClosure) {
        const auto generations = std::uint32_t(result.statistics.generations);
        m_steps = grownSteps(result.generation - generations, result.statistics, result.facts);
    }
}

} // namespace core
