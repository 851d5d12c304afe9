// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "tests/reference/ReferenceEngine.h"

#include <utility>

namespace reference {

/// The oracle, but one that cannot read codes while it is told so, as a GPU that has no memory left
/// for it.
class RefusingEngine final : public core::EditEngine {
public:
    bool refuses = true;

    core::Result<void> openVolume(
        const glm::ivec3& size, std::span<const std::uint16_t> codes) override
    {
        return m_inner.openVolume(size, codes);
    }
    core::Ticket submit(core::EngineCommand command) override
    {
        const bool isRefused = refuses && std::holds_alternative<core::ReadCodes>(command);
        const core::Ticket ticket = m_inner.submit(std::move(command));
        if (isRefused)
            m_refused.push_back(ticket);
        return ticket;
    }
    [[nodiscard]] std::vector<core::EngineResult> collect() override
    {
        std::vector<core::EngineResult> results = m_inner.collect();
        for (core::EngineResult& result : results) {
            if (std::erase(m_refused, result.ticket) == 0)
                continue;
            result.codes.clear();
            result.error =
                core::Error{core::ErrorCode::OutOfMemory, {QStringLiteral("no room for codes")}};
        }
        return results;
    }
    void finish() override { m_inner.finish(); }
    void setWakeUp(std::function<void()> wakeUp) override { m_inner.setWakeUp(std::move(wakeUp)); }
    [[nodiscard]] core::GrowthProgress growthProgress() const override
    {
        return m_inner.growthProgress();
    }

private:
    ReferenceEngine m_inner;
    std::vector<core::Ticket> m_refused;
};

} // namespace reference
