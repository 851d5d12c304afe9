// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/TaskThread.h"

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace core {

class SessionState;

/// A second thread for long work of operations that needs no engine. It works in the order of the
/// calls; poll() carries out what follows from the work.
class SideThread {
public:
    /// runs on the session's thread; may be empty
    using Sequel = std::function<void(SessionState&)>;
    using Work = std::function<Sequel()>; ///< runs on the side thread
    /// Runs on the session's thread if Work has thrown.
    using Failed = std::function<void(SessionState&, const Error&)>;

    /// @param wakeUp called on the side thread when collect() has something
    explicit SideThread(std::function<void()> wakeUp);

    void post(Work work, Failed failed);
    [[nodiscard]] std::vector<Sequel> collect();
    void finish();

private:
    void add(Sequel sequel);

    std::function<void()> m_wakeUp;
    std::mutex m_mutex;
    std::vector<Sequel> m_sequels; ///< under m_mutex
    /// Started with the first work. Last, since it uses all of the above.
    std::unique_ptr<TaskThread> m_thread;
};

} // namespace core
