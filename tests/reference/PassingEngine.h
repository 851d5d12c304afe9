// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "tests/reference/ReferenceEngine.h"

#include <utility>

namespace reference {

/// The oracle behind an engine that passes everything on. Tests derive from it engines that fail
/// somewhere.
class PassingEngine : public core::EditEngine {
public:
    core::Result<void> openVolume(
        const glm::ivec3& size, std::span<const std::uint16_t> codes) override
    {
        return m_inner.openVolume(size, codes);
    }
    core::Ticket submit(core::EngineCommand command) override
    {
        return m_inner.submit(std::move(command));
    }
    [[nodiscard]] std::vector<core::EngineResult> collect() override { return m_inner.collect(); }
    void finish() override { m_inner.finish(); }
    void setWakeUp(std::function<void()> wakeUp) override { m_inner.setWakeUp(std::move(wakeUp)); }
    [[nodiscard]] core::GrowthProgress growthProgress() const override
    {
        return m_inner.growthProgress();
    }

private:
    ReferenceEngine m_inner;
};

} // namespace reference
