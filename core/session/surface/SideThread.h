// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/TaskThread.h"

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace core {

class SessionState;

/// Where an operation has work done that takes long and asks no engine: a thread beside that of the
/// session, in the order of the calls. What follows from it is carried out by poll().
class SideThread {
public:
    using Sequel = std::function<void(SessionState&)>; ///< on the session's thread; may be empty
    using Work = std::function<Sequel()>; ///< on this one
    /// What follows where Work has thrown; on the session's thread.
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
    /// Begins with the first work. Last: it uses all of the above.
    std::unique_ptr<TaskThread> m_thread;
};

} // namespace core
