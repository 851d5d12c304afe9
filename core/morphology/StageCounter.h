// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/BallFilters.h"

#include <mutex>

namespace core {

/// Counts the steps of a filter that several threads carry out, and reports whole per cents.
class StageCounter {
public:
    StageCounter(const FilterStage& stage, std::int64_t total)
        : m_stage(stage)
        , m_total(total)
    {
    }

    [[nodiscard]] bool cancelled() const { return m_stage.progress.cancelled(); }
    void stepDone()
    {
        constexpr int percents = 100;
        const std::lock_guard lock(m_mutex);
        const auto now = int(++m_done * percents / m_total);
        if (now == m_told)
            return;
        m_told = now;
        m_stage.progress.report(
            ProgressStep::ReshapingSegment, m_stage.number * percents + now, m_stage.of * percents);
    }

private:
    const FilterStage& m_stage;
    const std::int64_t m_total;
    std::mutex m_mutex;
    std::int64_t m_done = 0;
    int m_told = 0;
};

} // namespace core
