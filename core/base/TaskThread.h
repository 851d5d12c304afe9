// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace core {

/// One thread that carries out tasks in the order they were posted. Any thread may post and wait.
class TaskThread {
public:
    TaskThread();
    /// Carries out what was posted, then ends.
    ~TaskThread();
    TaskThread(const TaskThread&) = delete;
    TaskThread& operator=(const TaskThread&) = delete;

    void post(std::function<void()> task);
    /// Posts and waits until it is done.
    void run(const std::function<void()>& task);
    /// Waits until everything posted so far is done.
    void finish();

private:
    void work();

    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<std::function<void()>> m_tasks;
    bool m_ending = false;
    std::thread m_thread; ///< last: it uses all of the above
};

} // namespace core
