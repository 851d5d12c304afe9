// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/trace/Trace.h"
#include "core/engine/EditEngine.h"
#include "core/engine/EngineCommands.h"
#include "gpu/engine/EditTransaction.h"
#include "gpu/engine/EngineThread.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <vector>

namespace gpu {

/// The queue between the session's thread and the engine's thread: commands go in, results come
/// out, with the meaning that core::EditEngine gives them. Functions may be called from any thread
/// unless their comment names one.
class CommandQueue : public core::EditEngine {
public:
    core::Ticket submit(core::EngineCommand command) final;
    [[nodiscard]] std::vector<core::EngineResult> collect() final;
    void finish() final;
    void giveUp(core::Ticket ended) final;
    void setWakeUp(std::function<void()> wakeUp) final;
    [[nodiscard]] core::GrowthProgress growthProgress() const final;

protected:
    struct Waiting {
        core::Ticket ticket = 0;
        core::EngineCommand command;
        core::Trace::Clock::time_point submitted{}; ///< if a trace is on
    };

    explicit CommandQueue(EngineThread& thread);
    ~CommandQueue() override = default;

    /// Takes the next command out of the queue, unless that command has to wait for growth steps of
    /// the open edit, or for what it has to read before it is committed. Engine thread.
    /// @param open null if no edit is open
    /// @return false if there is nothing to take
    [[nodiscard]] bool takeNext(Waiting& next, EditTransaction* open);
    /// Whether the next command is to commit the open edit.
    [[nodiscard]] bool commitIsNext() const;
    /// Records in a trace that the command is carried out, while the span lives.
    [[nodiscard]] static core::TraceSpan traced(const Waiting& taken);
    void deliver(core::EngineResult result);
    /// Reports that the command taken by takeNext() is done, and wakes threads that wait in
    /// finish().
    void publish(const core::GrowthProgress& progress);
    /// Whether a thread waits in finish(): a paced growth then runs as fast as it can.
    [[nodiscard]] bool inHurry() const;
    /// Whether @p moment has come. True at once while a thread waits in finish(). If false, the
    /// engine thread is woken at that moment.
    [[nodiscard]] bool isDue(EngineThread::Clock::time_point moment);

private:
    void takeMore(core::ExtendEdit& first, EditTransaction& open); ///< call with m_mutex held

    EngineThread& m_thread;
    mutable std::mutex m_mutex;
    std::condition_variable m_settled;
    // The members below are guarded by m_mutex.
    std::deque<Waiting> m_waiting;
    std::vector<core::EngineResult> m_results;
    core::GrowthProgress m_progress;
    std::function<void()> m_wakeUp;
    core::Ticket m_lastTicket = 0;
    bool m_busy = false;
    bool m_hurry = false; ///< a thread waits in finish()
};

} // namespace gpu
