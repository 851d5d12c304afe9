// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/end/EndSignals.h"
#include "core/base/Progress.h"
#include "core/base/TaskThread.h"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>

namespace app {

/// A command without an event loop that is told to end (SIGTERM, SIGINT, SIGHUP) ends in good
/// order. Its work is called off, and it leaves as after any failure: the session closed, nothing
/// staged left. Where that takes longer than a moment, since one step is not done, what was
/// registered is closed from another thread and the process ends there. OrderlyEnd is the same for
/// programs with an event loop. One per process.
class ToldToEnd {
public:
    ToldToEnd();
    ToldToEnd(const ToldToEnd&) = delete;
    ToldToEnd& operator=(const ToldToEnd&) = delete;
    ~ToldToEnd();

    /// Cancelled when the signal comes.
    [[nodiscard]] const core::Progress& progress() const { return m_progress; }
    /// @param closing leaves what is open whole on disk, from another thread, while a step is under
    /// way. Empty: nothing is open any more; waits where it is being closed
    void setClosing(std::function<void()> closing);
    /// The exit status of a command that would end with @p usual: that of shells (128 + signal)
    /// where it did not come to its end.
    [[nodiscard]] int status(int usual) const;

private:
    void watch();

    core::Progress m_progress;
    std::atomic<int> m_signal = 0;
    EndSignals m_signals;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::function<void()> m_closing; ///< under the mutex
    bool m_leaving = false; ///< what was open is being closed; under the mutex
    bool m_done = false; ///< under the mutex
    /// Last: it uses all of the above. None: no thread could be started, signals end the program as
    /// they always do.
    std::optional<core::TaskThread> m_thread;
};

} // namespace app
