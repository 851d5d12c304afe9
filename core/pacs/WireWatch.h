// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/TaskThread.h"
#include "core/pacs/Patience.h"

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>

namespace core {

/// Shuts a socket down from a thread of its own when work is cancelled or patience is lost: what
/// waits for it then returns, wherever that is. Libraries that read a whole record or shake hands
/// ask nobody on the way.
class WireWatch {
public:
    /// @param progress may be null
    WireWatch(int socket, const Progress* progress, std::shared_ptr<const Patience> patience);
    WireWatch(const WireWatch&) = delete;
    WireWatch& operator=(const WireWatch&) = delete;
    ~WireWatch() { end(); }

    /// Before the socket is closed. Once it has returned the socket is left alone.
    void end();

    [[nodiscard]] bool cancelled() const { return m_cancelled; }
    [[nodiscard]] Patience::Lost lost() const { return m_lost; }

private:
    void work();

    int m_socket;
    const Progress* m_progress;
    std::shared_ptr<const Patience> m_patience;
    std::atomic<bool> m_cancelled = false;
    std::atomic<Patience::Lost> m_lost = Patience::Lost::No;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_ending = false; ///< under the mutex
    TaskThread m_thread; ///< last: it uses all of the above
};

} // namespace core
