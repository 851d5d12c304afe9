// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace test {

/// A semaphore between threads. Unlike with Qt's, the thread sanitizer understands which order it
/// enforces (packaging/tsan.sh).
class Signal {
public:
    /// Raises the count by one.
    void release()
    {
        const std::lock_guard lock(m_mutex);
        ++m_count;
        m_changed.notify_one();
    }
    /// Waits until the count is above 0 and lowers it by one. It waits at most a minute, so that a
    /// failed test ends.
    void acquire()
    {
        std::unique_lock lock(m_mutex);
        if (m_changed.wait_for(lock, std::chrono::minutes(1), [this] { return m_count > 0; }))
            --m_count;
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    int m_count = 0;
};

} // namespace test
