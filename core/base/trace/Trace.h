// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <typeinfo>

namespace core {

/// The name of something in a trace: a word of the program itself, or one of its types. Text that
/// was read at run time cannot become a name, so a trace reveals nothing about a patient.
class TraceName {
public:
    TraceName() = default; ///< no name
    template <std::size_t size>
    consteval TraceName(const char (&literal)[size]) // NOLINT: a word is its name
        : m_text(literal)
    {
    }
    /// The name of a type; for a lambda, that of the function that contains it.
    explicit TraceName(const std::type_info& type)
        : m_type(&type)
    {
    }
    /// @param text a word of the program, which must exist as long as the program runs; null: no
    /// name
    [[nodiscard]] static TraceName lasting(const char* text);

    [[nodiscard]] std::string text() const;

private:
    const char* m_text = nullptr;
    const std::type_info* m_type = nullptr;
};

/// Records when the program did what, as a timeline with lanes: one for each thread, one for each
/// graphics context (gpu/gl/GpuTrace.h), one for each view. It is off until begin(); as long as it
/// is off, each attempt to record costs one relaxed atomic load and no memory. Any thread may
/// record.
class Trace {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::size_t mostEvents = 1'000'000;

    struct Event {
        TraceName category;
        TraceName name;
        TraceName detail{}; ///< what exactly was done, for example the kind of an edit
        int lane = 0;
        Clock::time_point begin;
        Clock::time_point end;
        /// How long it had waited before it began; negative: it did not wait.
        std::int64_t waitedMicroseconds = -1;
    };

    [[nodiscard]] static bool isOn() noexcept { return s_on.load(std::memory_order_relaxed); }
    /// Begins a new trace and discards the previous one. The lane of the calling thread is named
    /// "main".
    /// @param most the number of events to record; later ones are only counted
    static void begin(std::size_t most = mostEvents);
    /// Ends the trace.
    /// @return the whole trace as JSON, in the form that chrome://tracing and Perfetto read: an
    /// array of complete events with microseconds since begin(), preceded by the names of the lanes
    [[nodiscard]] static std::string end();

    /// Records an event that has ended. Does nothing while the trace is off. An event for which
    /// there is no memory is only counted.
    static void add(const Event& event) noexcept;
    /// Names the lane of the calling thread, unless the thread already has a lane.
    static void nameThread(TraceName name);
    [[nodiscard]] static int laneOfThread();

private:
    inline static std::atomic<bool> s_on{false};
};

/// A lane, for events that nest or follow one another. After it is destroyed, the next lane with
/// the same name continues it, so that short-lived threads share one.
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
    std::chrono::nanoseconds least{0}; ///< an event that takes less time is not recorded
};

/// Records one event on the lane of the calling thread; the event lasts as long as this object
/// lives.
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
