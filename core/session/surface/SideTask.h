// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/session/surface/SideThread.h"

#include <atomic>
#include <functional>

namespace core {

/// What work on the side thread shares with the session's thread, which shows how far it is and may
/// abort it.
struct SideWatch {
    SideWatch();
    std::atomic<int> percent = -1; ///< as reported by `progress`; −1: nothing was reported yet
    Progress progress;
};

/// What an operation asked the side thread to do, one thing at a time. While it is away the
/// operation must not end, because what comes back belongs to it.
class SideTask {
public:
    /// @param work must return a sequel
    /// @param failed called if @p work has thrown; its arguments are as in SideThread::post()
    void post(SideThread& side, SideThread::Work work, SideThread::Failed failed);
    /// Nothing follows from the work any more: @p instead is called when it comes back, or now if
    /// nothing is away.
    void giveUp(std::function<void()> instead);
    [[nodiscard]] bool isAway() const { return m_isAway; }

private:
    /// @return false: it was given up
    bool comeBack();

    bool m_isAway = false;
    std::function<void()> m_instead;
};

} // namespace core
