// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace core {

/// One thread that carries out tasks in the order they were posted. Any thread may post and wait.
/// What a task throws ends in somebody's hands: the threads of this program are made here, in
/// ParallelFor and by the engine, nowhere else.
class TaskThread {
public:
    /// Throws std::system_error where no further thread can be started.
    TaskThread();
    /// Carries out what was posted, then ends.
    ~TaskThread();
    TaskThread(const TaskThread&) = delete;
    TaskThread& operator=(const TaskThread&) = delete;

    /// @param failed told, on this thread, what @p task has thrown; must not throw
    void post(std::function<void()> task, std::function<void(const Error&)> failed);
    /// Posts and waits until it is done. What it throws is thrown here.
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
    std::thread m_thread; ///< last: it uses all of the above
};

} // namespace core
