// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"

#include <cstdint>
#include <mutex>

namespace core {

/// The progress of one step that several threads carry out together. The listener of the progress
/// is called by one thread at a time, never with a smaller value than before, and not after the
/// work was cancelled.
class SharedProgress {
public:
    /// @param total the amount of work, in any unit; advance() counts in the same unit
    SharedProgress(const Progress& progress, ProgressStep step, std::int64_t total)
        : m_progress(progress)
        , m_step(step)
        , m_total(total > 0 ? total : 1)
    {
        static_cast<void>(advance(0));
    }
    /// Adds to the amount of work done. Any thread.
    /// @return false: the work was cancelled
    bool advance(std::int64_t more)
    {
        const std::lock_guard lock(m_mutex);
        if (m_progress.cancelled())
            return false;
        m_done += more;
        m_progress.report(m_step, int(shares * m_done / m_total), int(shares));
        return !m_progress.cancelled();
    }

private:
    static constexpr std::int64_t shares = 1000;

    const Progress& m_progress;
    ProgressStep m_step;
    std::int64_t m_total;
    std::mutex m_mutex;
    std::int64_t m_done = 0; ///< under m_mutex
};

} // namespace core
