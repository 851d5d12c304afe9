// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/ProgressStep.h"

#include <atomic>
#include <functional>

namespace core {

/// Through this class a long task reports its progress and learns that it was cancelled.
///
/// The worker calls report() and asks cancelled(); any thread may call cancel().
class Progress {
public:
    using Listener = std::function<void(ProgressStep step, int done, int total)>;

    Progress() = default;
    /// @param listener called on the worker's thread; must return quickly
    explicit Progress(Listener listener)
        : m_listener(std::move(listener))
    {
    }

    void report(ProgressStep step, int done, int total) const
    {
        if (m_listener)
            m_listener(step, done, total);
    }
    void cancel() { m_cancelled = true; }
    [[nodiscard]] bool cancelled() const { return m_cancelled; }

private:
    Listener m_listener;
    std::atomic<bool> m_cancelled = false;
};

} // namespace core
