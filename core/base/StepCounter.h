// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"

#include <mutex>

namespace core {

/// Counts steps that are done on several threads; the listener is called for one at a time, in
/// order.
class StepCounter {
public:
    StepCounter(const Progress& progress, ProgressStep step, int total)
        : m_progress(progress)
        , m_step(step)
        , m_total(total)
    {
    }

    void stepDone()
    {
        const std::lock_guard lock(m_mutex);
        m_progress.report(m_step, ++m_done, m_total);
    }

private:
    const Progress& m_progress;
    const ProgressStep m_step;
    const int m_total;
    std::mutex m_mutex;
    int m_done = 0;
};

} // namespace core
