// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "gpu/gl/GlContext.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace gpu {

/// The one thread on which all GL work is done, one context current from start to end.
///
/// Its loop: jobs in the order they were posted, then one slice of edits, then one slice of
/// frames, and again; when none has anything to do it sleeps until woken.
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

    /// Queue a job; any thread. Jobs must be short, and must not throw.
    void post(Job job);
    /// Queue a job and wait for it; any thread (on the engine thread it runs at once). What it
    /// throws is thrown here.
    void run(const Job& job);
    /// There is something to do; any thread.
    void wake();
    /// Wake by yourself at this time; the earliest asked for counts. Engine thread.
    void wakeAt(Clock::time_point time);
    /// What the loop calls, edits first. Engine thread.
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
