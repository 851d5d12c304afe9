// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <typeinfo>

namespace core {

/// What something in a trace is called: a word of the program itself, or one of its types. Nothing
/// that was read at run time can become a name, so a trace tells of no patient.
class TraceName {
public:
    TraceName() = default; ///< none
    template <std::size_t size>
    consteval TraceName(const char (&literal)[size]) // NOLINT: a word is its name
        : m_text(literal)
    {
    }
    /// A type, and of a lambda the function that it stands in.
    explicit TraceName(const std::type_info& type)
        : m_type(&type)
    {
    }
    /// @param text a word of the program, which is there as long as it runs; null: none
    [[nodiscard]] static TraceName lasting(const char* text);

    [[nodiscard]] std::string text() const;

private:
    const char* m_text = nullptr;
    const std::type_info* m_type = nullptr;
};

/// What happened when while the program ran, on lanes: one for each thread, one for each graphics
/// context (gpu/gl/GpuTrace.h), one for each view. It is off until begin(); recording then costs
/// one relaxed atomic load and takes no memory. Any thread may record.
class Trace {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::size_t mostEvents = 1'000'000;

    struct Event {
        TraceName category;
        TraceName name;
        TraceName detail{}; ///< of what kind it was
        int lane = 0;
        Clock::time_point begin;
        Clock::time_point end;
        std::int64_t waitedMicroseconds = -1; ///< before it began; negative: it did not wait
    };

    [[nodiscard]] static bool isOn() noexcept { return s_on.load(std::memory_order_relaxed); }
    /// Begins a new trace. The calling thread is the one named "main".
    /// @param most events; later ones are counted only
    static void begin(std::size_t most = mostEvents);
    /// Ends it.
    /// @return all of it as JSON, in the form that chrome://tracing and Perfetto read: an array of
    /// complete events with microseconds since begin(), the names of the lanes before them
    [[nodiscard]] static std::string end();

    /// Records what is over; nothing while it is off. What finds no memory is counted only.
    static void add(const Event& event) noexcept;
    /// Names the lane of the calling thread, if it has none yet.
    static void nameThread(TraceName name);
    [[nodiscard]] static int laneOfThread();

private:
    inline static std::atomic<bool> s_on{false};
};

/// A lane for what nests or follows one another. When it is destroyed, the next lane of that name
/// continues it, so that threads which come and go share one.
class TraceLane {
public:
    explicit TraceLane(const std::string& name);
    ~TraceLane();
    TraceLane(const TraceLane&) = delete;
    TraceLane& operator=(const TraceLane&) = delete;

    [[nodiscard]] int id() const { return m_id; }

private:
    int m_id = 0;
};

struct TraceOptions {
    TraceName detail{};
    std::int64_t waitedMicroseconds = -1; ///< as in Trace::Event
    std::chrono::nanoseconds least{0}; ///< what takes less is not recorded
};

/// Records, on the lane of its thread, what happens while it lives.
class TraceSpan {
public:
    TraceSpan(TraceName category, TraceName name, const TraceOptions& options = {});
    ~TraceSpan();
    TraceSpan(const TraceSpan&) = delete;
    TraceSpan& operator=(const TraceSpan&) = delete;

private:
    const bool m_on;
    TraceName m_category;
    TraceName m_name;
    TraceOptions m_options;
    Trace::Clock::time_point m_begin;
};

} // namespace core
