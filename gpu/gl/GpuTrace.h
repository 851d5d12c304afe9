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
/// for core::Trace. Nothing waits for an answer: what has arrived is taken when more is measured.
/// If no trace is on, a kernel or draw costs no more than a look at a pointer.
///
/// Make and destroy it on the thread of a context, with that current; at most one per thread.
class GpuTrace {
public:
    /// Measures only if a trace is on and the driver has timestamps.
    GpuTrace();
    /// Waits for what is still under way.
    ~GpuTrace();
    GpuTrace(const GpuTrace&) = delete;
    GpuTrace& operator=(const GpuTrace&) = delete;

    /// Says which program draws from now on.
    /// @param label stays as long as the program runs (core::TraceName)
    static void use(const char* label)
    {
        if (s_here)
            s_here->m_used = label;
    }

    /// Measures what is queued while it lives: one kernel, or one draw, of the program in use.
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
    /// More are under way only if the driver keeps its answers to itself; then some are left out.
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
    std::chrono::nanoseconds m_toClock{}; ///< to add to the driver's time
    core::Trace::Clock::time_point m_last; ///< the end of what was recorded last
    std::optional<Measured> m_open;
    std::deque<Measured> m_underWay; ///< in the order of queueing
    std::vector<Query> m_free;
};

} // namespace gpu
