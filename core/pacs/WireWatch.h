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

/// Shuts a socket down, from its own thread, when the work is cancelled or a limit of Patience is
/// exceeded. Whatever is waiting for the socket then returns. This is necessary because libraries
/// that read a whole record or do a handshake cannot be interrupted otherwise.
class WireWatch {
public:
    /// @param progress may be null
    WireWatch(int socket, const Progress* progress, std::shared_ptr<const Patience> patience);
    WireWatch(const WireWatch&) = delete;
    WireWatch& operator=(const WireWatch&) = delete;
    ~WireWatch() { end(); }

    /// To be called before the socket is closed; afterwards the socket is not touched any more.
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
    TaskThread m_thread; ///< last, since it uses all of the above
};

} // namespace core
