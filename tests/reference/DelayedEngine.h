// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"
#include "core/engine/EngineCommands.h"

#include <atomic>
#include <cstdint>
#include <deque>
#include <map>
#include <random>
#include <thread>

namespace reference {

/// Any engine, made late: commands reach it in bursts and its results come out in bursts, as on a
/// GPU whose fences take their time (DESIGN §2). The schedule counts calls of submit() and
/// collect() and is a function of the seed alone; it changes no result and no order. finish()
/// brings everything forward.
///
/// While something is held back a thread of its own wakes the caller every millisecond.
class DelayedEngine final : public core::EditEngine {
public:
    /// @param inner borrowed; nobody else may use it meanwhile
    DelayedEngine(core::EditEngine& inner, std::uint32_t seed);
    ~DelayedEngine() override;
    DelayedEngine(const DelayedEngine&) = delete;
    DelayedEngine& operator=(const DelayedEngine&) = delete;

    core::Result<void> openVolume(
        const glm::ivec3& size, std::span<const std::uint16_t> codes) override;
    core::Ticket submit(core::EngineCommand command) override;
    [[nodiscard]] std::vector<core::EngineResult> collect() override;
    void finish() override;
    void setWakeUp(std::function<void()> wakeUp) override;
    [[nodiscard]] core::GrowthProgress growthProgress() const override;

private:
    struct Waiting {
        core::Ticket ticket = 0;
        core::EngineCommand command;
    };

    void forward(std::size_t count);
    void takeResults();
    void stopWaking();

    core::EditEngine& m_inner;
    std::mt19937 m_random;
    std::deque<Waiting> m_commands;
    std::map<core::Ticket, core::Ticket> m_outerTickets; ///< by the inner engine's ticket
    std::deque<core::EngineResult> m_results;
    core::Ticket m_lastTicket = 0;
    int m_silentCollects = 0;
    bool m_flushed = false;

    std::function<void()> m_wakeUp;
    std::atomic<bool> m_holding = false;
    std::atomic<bool> m_stop = false;
    std::thread m_waker;
};

} // namespace reference
