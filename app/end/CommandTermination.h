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

/// Ends a command without an event loop in an orderly way when it is told to end (SIGTERM, SIGINT,
/// SIGHUP). Its work is cancelled, and it finishes as after any failure: the session is closed, and
/// no staged file is left. If that takes longer than a moment, because a step is not done, what
/// setClosing() has registered is closed from another thread and the process exits there.
/// OrderlyEnd does the same for programs with an event loop. One per process.
class CommandTermination {
public:
    CommandTermination();
    CommandTermination(const CommandTermination&) = delete;
    CommandTermination& operator=(const CommandTermination&) = delete;
    ~CommandTermination();

    /// Is cancelled when the signal arrives; pass it to all work.
    [[nodiscard]] const core::Progress& progress() const { return m_progress; }
    /// @param closing closes what is open, so that it is complete on disk; called on another thread
    /// while a step is under way. Empty: nothing is open any more; then this call waits while
    /// something is being closed
    void setClosing(std::function<void()> closing);
    /// The exit status of a command that would otherwise end with @p usual: as shells have it (128
    /// + signal) if the command was interrupted.
    [[nodiscard]] int status(int usual) const;

private:
    void watch();

    core::Progress m_progress;
    std::atomic<int> m_signal = 0;
    EndSignals m_signals;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::function<void()> m_closing; ///< guarded by m_mutex
    bool m_leaving = false; ///< what was open is being closed; guarded by m_mutex
    bool m_done = false; ///< guarded by m_mutex
    /// Last, because it uses all of the above. None if no thread could be started; then signals end
    /// the program as usual.
    std::optional<core::TaskThread> m_thread;
};

} // namespace app
