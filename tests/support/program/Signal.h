// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace test {

/// A semaphore for threads. Unlike Qt's, the thread sanitizer sees what it orders
/// (packaging/tsan.sh).
class Signal {
public:
    void release()
    {
        const std::lock_guard lock(m_mutex);
        ++m_count;
        m_changed.notify_one();
    }
    /// For a minute at most, so that a test that has failed ends.
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
