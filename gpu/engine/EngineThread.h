// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "gpu/gl/context/GlContext.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace gpu {

/// The one thread on which all GL work is done. Its context is current there from start to end.
///
/// Its loop runs the posted jobs in order, then one slice of edits, then one slice of frames, and
/// starts over. When nothing is left to do it sleeps until it is woken.
class EngineThread {
public:
    using Clock = std::chrono::steady_clock;
    using Job = std::function<void()>;
    /// One slice of ≤ 10 ms; returns whether more is to do at once.
    using Slice = std::function<bool()>;

    explicit EngineThread(std::unique_ptr<GlContext> context);
    /// Finishes the posted jobs, then stops.
    ~EngineThread();
    EngineThread(const EngineThread&) = delete;
    EngineThread& operator=(const EngineThread&) = delete;

    /// Errors: GraphicsUnavailable where the context cannot be made current. Throws
    /// std::system_error where no further thread can be started. Call once.
    core::Result<void> start();

    /// Queues a job; any thread. A job must be short and must not throw.
    void post(Job job);
    /// Queues a job and waits for it; any thread. On the engine thread the job runs at once. An
    /// exception of the job is rethrown here.
    void run(const Job& job);
    /// Tells the thread that there is something to do; any thread.
    void wake();
    /// Makes the thread wake up at this time; if several times were requested, at the earliest.
    /// Engine thread.
    void wakeAt(Clock::time_point time);
    /// Sets the two functions that the loop calls, edits first. Engine thread.
    void setSlices(Slice edits, Slice frames);

private:
    void loop();

    std::unique_ptr<GlContext> m_context;
    std::thread m_thread;
    std::mutex m_mutex;
    std::condition_variable m_wakeUp;
    std::deque<Job> m_jobs; ///< guarded by m_mutex
    bool m_woken = false; ///< guarded by m_mutex
    bool m_stopping = false; ///< guarded by m_mutex
    std::optional<Clock::time_point> m_alarm; ///< engine thread
    Slice m_edits; ///< engine thread
    Slice m_frames; ///< engine thread
};

} // namespace gpu
