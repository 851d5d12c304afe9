// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reference/PassingEngine.h"

#include <utility>
#include <vector>

namespace reference {

/// The oracle, but one that cannot read codes while it is told so, as a GPU that has no memory left
/// for it.
class RefusingEngine final : public PassingEngine {
public:
    bool refuses = true;

    core::Ticket submit(core::EngineCommand command) override
    {
        const bool isRefused = refuses && std::holds_alternative<core::ReadCodes>(command);
        const core::Ticket ticket = PassingEngine::submit(std::move(command));
        if (isRefused)
            m_refused.push_back(ticket);
        return ticket;
    }
    [[nodiscard]] std::vector<core::EngineResult> collect() override
    {
        std::vector<core::EngineResult> results = PassingEngine::collect();
        for (core::EngineResult& result : results) {
            if (std::erase(m_refused, result.ticket) == 0)
                continue;
            result.codes.clear();
            result.error =
                core::Error{core::ErrorCode::OutOfMemory, {QStringLiteral("no room for codes")}};
        }
        return results;
    }

private:
    std::vector<core::Ticket> m_refused;
};

} // namespace reference
