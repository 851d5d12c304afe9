// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/trace/Trace.h"
#include "gpu/gl/GlId.h"

#include <chrono>
#include <cstddef>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace gpu {

/// Measures on the graphics processor when each kernel and each draw of a context begins and ends,
/// for core::Trace. It never waits for the driver: results that have arrived are collected when the
/// next measurement starts. Without a trace, a kernel or draw costs only a check of a pointer.
///
/// Create and destroy it on the thread of a context while that is current; at most one per thread.
class GpuTrace {
public:
    /// Measures only if a trace is on and the driver supports timestamps.
    GpuTrace();
    /// Waits for the results that are still missing.
    ~GpuTrace();
    GpuTrace(const GpuTrace&) = delete;
    GpuTrace& operator=(const GpuTrace&) = delete;

    /// Names the program whose kernels and draws follow.
    /// @param label must live as long as the process (core::TraceName)
    static void use(const char* label)
    {
        if (s_here)
            s_here->m_used = label;
    }

    /// Measures the commands queued during its lifetime: one kernel or draw of the program in use.
    class Span {
    public:
        Span()
        {
            if (s_here)
                s_here->begin();
        }
        ~Span()
        {
            if (s_here)
                s_here->end();
        }
        Span(const Span&) = delete;
        Span& operator=(const Span&) = delete;
    };

private:
    using Query = GlId<glDelete::query>;
    struct Measured {
        const char* label = nullptr;
        Query begin;
        Query end;
    };
    /// Most measurements that may wait for a result. Only a driver that does not deliver results
    /// reaches it; then some kernels are not measured.
    static constexpr std::size_t mostUnderWay = 4096;

    void begin();
    void end();
    void takeArrived();
    [[nodiscard]] Query stamp();
    [[nodiscard]] core::Trace::Clock::time_point timeOf(const Query& query) const;

    inline static constinit thread_local GpuTrace* s_here = nullptr;

    const char* m_used = nullptr;
    std::optional<core::TraceLane> m_lane; ///< none: it measures nothing
    bool m_flushes = false;
    std::chrono::nanoseconds m_toClock{}; ///< to be added to the driver's time
    core::Trace::Clock::time_point m_last; ///< end of the last recorded measurement
    std::optional<Measured> m_open;
    std::deque<Measured> m_underWay; ///< in the order of queueing
    std::vector<Query> m_free;
};

} // namespace gpu
