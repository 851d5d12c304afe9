// SPDX-License-Identifier: Apache-2.0
#include "core/base/trace/Trace.h"

#include <cxxabi.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>
#include <vector>

namespace core {

namespace {

struct Lane {
    std::string name;
    bool taken = true;
};

/// Threads that end after main() still give their lanes back, so it is never destroyed.
struct Store {
    std::mutex mutex;
    // All below is guarded by it.
    std::deque<Trace::Event> events;
    std::vector<Lane> lanes; ///< never fewer, since threads keep their numbers
    Trace::Clock::time_point begun;
    std::size_t most = 0;
    std::size_t leftOut = 0;
};

Store& store()
{
    static auto* const made = new Store;
    return *made;
}

thread_local std::optional<TraceLane> laneHere;

/// What std::type_info tells, as it is written in the source: of a lambda the function around it.
std::string readable(const char* mangled)
{
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> text(
        abi::__cxa_demangle(mangled, nullptr, nullptr, &status), &std::free);
    std::string name = text ? text.get() : mangled;
    constexpr std::string_view unnamed = "(anonymous namespace)::";
    for (auto at = name.find(unnamed); at != std::string::npos; at = name.find(unnamed))
        name.erase(at, unnamed.size());
    if (const auto parameters = name.find('('); parameters != std::string::npos && parameters > 0)
        name.resize(parameters);
    return name;
}

std::string quoted(const std::string& text)
{
    std::string quote = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\')
            quote += '\\';
        const bool isControl = static_cast<unsigned char>(letter) < 0x20;
        quote += isControl ? ' ' : letter;
    }
    return quote + '"';
}

/// Thousandths of a microsecond stay exact.
std::string microseconds(std::chrono::nanoseconds time)
{
    const std::int64_t nanoseconds = std::max<std::int64_t>(time.count(), 0);
    const std::string rest = std::to_string(nanoseconds % 1000);
    return std::to_string(nanoseconds / 1000) + '.' + std::string(3 - rest.size(), '0') + rest;
}

std::string jsonOf(const Trace::Event& event, Trace::Clock::time_point begun)
{
    // Both ends are measured from begun and what is between them is their difference, so that what
    // nests does so in the file, too.
    std::string line = R"({"ph":"X","pid":1,"tid":)" + std::to_string(event.lane) + R"(,"cat":)"
        + quoted(event.category.text()) + R"(,"name":)" + quoted(event.name.text()) + R"(,"ts":)"
        + microseconds(event.begin - begun) + R"(,"dur":)" + microseconds(event.end - event.begin);
    const std::string detail = event.detail.text();
    std::string arguments = detail.empty() ? std::string() : R"("of":)" + quoted(detail);
    if (event.waitedMicroseconds >= 0)
        arguments += (arguments.empty() ? "" : ",") + std::string(R"("waitedMicroseconds":)")
            + std::to_string(event.waitedMicroseconds);
    if (!arguments.empty())
        line += R"(,"args":{)" + arguments + '}';
    return line + '}';
}

std::string jsonOf(int id, const Lane& lane)
{
    return R"({"ph":"M","pid":1,"tid":)" + std::to_string(id)
        + R"(,"name":"thread_name","args":{"name":)" + quoted(lane.name) + "}}";
}

} // namespace

TraceName TraceName::lasting(const char* text)
{
    TraceName name;
    name.m_text = text;
    return name;
}

std::string TraceName::text() const
{
    if (m_type)
        return readable(m_type->name());
    return m_text ? m_text : "";
}

void Trace::begin(std::size_t most)
{
    {
        Store& held = store();
        const std::lock_guard lock(held.mutex);
        held.events.clear();
        held.begun = Clock::now();
        held.most = most;
        held.leftOut = 0;
    }
    nameThread("main");
    s_on.store(true, std::memory_order_relaxed);
}

std::string Trace::end()
{
    s_on.store(false, std::memory_order_relaxed);
    Store& held = store();
    const std::lock_guard lock(held.mutex);
    std::vector<bool> used(held.lanes.size());
    for (const Event& event : held.events)
        used[std::size_t(event.lane)] = true;
    std::string json = "[";
    const auto append = [&json](const std::string& line) {
        json += json.size() > 1 ? ",\n" : "\n";
        json += line;
    };
    for (std::size_t id = 0; id < held.lanes.size(); ++id) {
        if (used[id])
            append(jsonOf(int(id), held.lanes[id]));
    }
    for (const Event& event : held.events)
        append(jsonOf(event, held.begun));
    if (held.leftOut > 0)
        append(R"({"ph":"M","pid":1,"name":"events left out","args":{"count":)"
            + std::to_string(held.leftOut) + "}}");
    held.events.clear();
    return json + "\n]\n";
}

void Trace::add(const Event& event) noexcept
{
    if (!isOn())
        return;
    Store& held = store();
    const std::lock_guard lock(held.mutex);
    try {
        if (held.events.size() < held.most) {
            held.events.push_back(event);
            return;
        }
    } catch (const std::exception&) {
        // Counted below, like what is too much.
    }
    ++held.leftOut;
}

void Trace::nameThread(TraceName name)
{
    if (!laneHere)
        laneHere.emplace(name.text());
}

int Trace::laneOfThread()
{
    nameThread("thread");
    return laneHere->id();
}

TraceLane::TraceLane(const std::string& name)
{
    Store& held = store();
    const std::lock_guard lock(held.mutex);
    const auto free = std::find_if(held.lanes.begin(), held.lanes.end(),
        [&name](const Lane& lane) { return !lane.taken && lane.name == name; });
    m_id = int(free - held.lanes.begin());
    if (free != held.lanes.end())
        free->taken = true;
    else
        held.lanes.push_back({.name = name});
}

TraceLane::~TraceLane()
{
    Store& held = store();
    const std::lock_guard lock(held.mutex);
    held.lanes[std::size_t(m_id)].taken = false;
}

TraceSpan::TraceSpan(TraceName category, TraceName name, const TraceOptions& options)
    : m_on(Trace::isOn())
{
    if (!m_on)
        return;
    m_category = category;
    m_name = name;
    m_options = options;
    m_begin = Trace::Clock::now();
}

TraceSpan::~TraceSpan()
{
    if (!m_on)
        return;
    const Trace::Clock::time_point end = Trace::Clock::now();
    if (end - m_begin < m_options.least)
        return;
    int lane = 0;
    try {
        lane = Trace::laneOfThread();
    } catch (const std::exception&) {
        return; // without memory for a lane there is none for the event
    }
    Trace::add({.category = m_category,
        .name = m_name,
        .detail = m_options.detail,
        .lane = lane,
        .begin = m_begin,
        .end = end,
        .waitedMicroseconds = m_options.waitedMicroseconds});
}

} // namespace core
