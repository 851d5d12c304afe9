// SPDX-License-Identifier: Apache-2.0
// Oracle: how an open edit ends, and what is told of its growth.
#include "tests/reference/Oracle.h"

#include <algorithm>

namespace reference {

std::uint32_t Oracle::generationBefore(const Growth& growth)
{
    return growth.openedAt();
}

std::uint32_t Oracle::generationBefore(const Shrunk& shrunk)
{
    return shrunk.edit.generation;
}

std::uint32_t Oracle::generationBefore(const CutBack& cut)
{
    return cut.edit.generation;
}

void Oracle::report(const Growth& growth, core::EngineResult& result)
{
    result.generation = growth.generation();
    result.atClosure = growth.atClosure();
    result.alarm = growth.alarm();
    result.statistics.generations = int(growth.frontSizes().size());
}

void Oracle::report(const Shrunk& shrunk, core::EngineResult& result)
{
    result.generation = shrunk.to;
    result.statistics.generations = int(shrunk.edit.generation - shrunk.to);
}

void Oracle::report(const CutBack& cut, core::EngineResult& result)
{
    result.generation = cut.done.generation;
    result.statistics.generations = cut.edit.how == core::CutGrowth::How::Backwards
        ? int(cut.done.backwards.steps)
        : std::max(int(cut.edit.generation) - int(cut.done.generation), 0);
}

void Oracle::report(const Growth& growth, core::GrowthProgress& progress)
{
    progress.open = true;
    progress.atClosure = growth.atClosure();
    progress.generation = growth.generation();
    progress.frontSizes = growth.frontSizes();
    progress.alarm = growth.alarm();
    for (const std::uint32_t size : progress.frontSizes)
        progress.members += size;
}

void Oracle::report(const CutBack& cut, core::GrowthProgress& progress)
{
    if (cut.edit.how == core::CutGrowth::How::Backwards)
        progress.backwards = cut.done.backwards;
}

core::GrowthProgress Oracle::growthProgress() const
{
    core::GrowthProgress progress;
    if (m_open)
        std::visit([&progress](const auto& work) { report(work, progress); }, m_open->work);
    return progress;
}

/// As far as the work asks for it.
std::optional<std::int32_t> Oracle::searchedTo() const
{
    return std::visit(
        [](const auto& work) -> std::optional<std::int32_t> {
            if constexpr (requires { work.searchedTo(); })
                return work.searchedTo();
            else
                return std::nullopt;
        },
        m_open->work);
}

Oracle::Outcome Oracle::carryOut(core::EndEdit& command)
{
    if (!m_open)
        return core::failure(core::ErrorCode::InvalidField, QStringLiteral("transaction"),
            QStringLiteral("no edit is open"));
    core::EngineResult result;
    if (command.ending == core::Ending::Rollback) {
        result.generation =
            std::visit([](const auto& work) { return generationBefore(work); }, m_open->work);
        m_fields = std::move(m_open->before);
    } else {
        result.changes = DenseFields::changes(m_open->before, m_fields);
        result.facts = core::factsOf(result.changes, core::BrickGrid{m_codes.size});
        result.statistics = core::statisticsOf(result.facts);
        std::visit([&result](const auto& work) { report(work, result); }, m_open->work);
        result.statistics.searchedTo = searchedTo();
    }
    m_open.reset();
    return result;
}

} // namespace reference
