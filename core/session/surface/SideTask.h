// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/surface/SideThread.h"

#include <functional>

namespace core {

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
