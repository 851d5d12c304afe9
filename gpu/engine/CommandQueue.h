// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"
#include "gpu/engine/EditTransaction.h"
#include "gpu/engine/EngineThread.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <vector>

namespace gpu {

/// The session's side of the engine: commands in, results out, as core::EditEngine has it. What
/// carries them out stands behind it (GpuEditEngine) and takes them on the engine's thread. Any
/// thread, but for what says otherwise.
class CommandQueue : public core::EditEngine {
public:
    core::Ticket submit(core::EngineCommand command) final;
    [[nodiscard]] std::vector<core::EngineResult> collect() final;
    void finish() final;
    void setWakeUp(std::function<void()> wakeUp) final;
    [[nodiscard]] core::GrowthProgress growthProgress() const final;

protected:
    struct Waiting {
        core::Ticket ticket = 0;
        core::EngineCommand command;
    };

    explicit CommandQueue(EngineThread& thread);
    ~CommandQueue() override = default;

    /// Takes the next command unless it has to wait for steps of a growth. Engine thread.
    /// @param open null: none is
    [[nodiscard]] bool takeNext(Waiting& next, EditTransaction* open);
    void deliver(core::EngineResult result);
    /// The command that was taken is done.
    void publish(const core::GrowthProgress& progress);
    /// Somebody waits for the end: no pace.
    [[nodiscard]] bool inHurry() const;
    /// Whether that moment has come, or nobody may wait for it; else the engine's thread wakes
    /// then.
    [[nodiscard]] bool isDue(EngineThread::Clock::time_point moment);

private:
    void takeMore(core::ExtendEdit& first, EditTransaction& open); ///< m_mutex is held

    EngineThread& m_thread;
    mutable std::mutex m_mutex;
    std::condition_variable m_settled;
    // Under m_mutex:
    std::deque<Waiting> m_waiting;
    std::vector<core::EngineResult> m_results;
    core::GrowthProgress m_progress;
    std::function<void()> m_wakeUp;
    core::Ticket m_lastTicket = 0;
    bool m_busy = false;
    bool m_hurry = false; ///< finish() is waiting
};

} // namespace gpu
