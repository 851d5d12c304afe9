// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace core {

/// One thread that carries out tasks in the order in which they were posted. Any thread may post
/// and wait. Exceptions of a task are always passed on. All threads of the program are created
/// here, in ParallelFor and by the engine, and nowhere else.
class TaskThread {
public:
    /// Throws std::system_error if no further thread can be started.
    TaskThread();
    /// Carries out what was posted, then ends.
    ~TaskThread();
    TaskThread(const TaskThread&) = delete;
    TaskThread& operator=(const TaskThread&) = delete;

    /// @param failed called on this thread with what @p task has thrown; must not throw
    void post(std::function<void()> task, std::function<void(const Error&)> failed);
    /// Posts a task and waits until it is done. What it throws is rethrown here.
    void run(const std::function<void()>& task);
    /// Waits until everything posted so far is done.
    void finish();

private:
    struct Task {
        std::function<void()> carryOut;
        std::function<void(const Error&)> failed;
    };
    void work();

    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<Task> m_tasks;
    bool m_ending = false;
    std::thread m_thread; ///< last, since it uses all of the above
};

/// One task that runs on a thread of its own while its owner does something else. If no thread can
/// be started, finish() carries it out. Unlike the work of parallelFor() it runs in parallel with
/// calls of parallelFor().
class LoneTask {
public:
    explicit LoneTask(std::function<void()> task);
    /// Waits for a task that has begun. A task that no thread has taken over is not carried out.
    ~LoneTask() = default;
    LoneTask(const LoneTask&) = delete;
    LoneTask& operator=(const LoneTask&) = delete;

    /// Waits until the task is done, and rethrows what it has thrown. To be called once at most, by
    /// any thread.
    void finish();

private:
    std::function<void()> m_task;
    std::exception_ptr m_thrown; ///< written by the thread
    std::optional<TaskThread> m_thread; ///< last, since it uses all of the above
};

} // namespace core
