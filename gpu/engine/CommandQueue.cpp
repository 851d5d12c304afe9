// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/CommandQueue.h"

#include <chrono>
#include <typeinfo>
#include <utility>
#include <variant>

namespace gpu {

namespace {

/// Keeps the slice of a path that has waited long within bounds.
constexpr int extensionsAtOnce = 16;

template <class Known> core::TraceName kindOf(const Known& variant)
{
    return std::visit([](const auto& known) { return core::TraceName(typeid(known)); }, variant);
}

bool isCommit(const core::EngineCommand& command)
{
    const auto* end = std::get_if<core::EndEdit>(&command);
    return end && end->ending == core::Ending::Commit;
}

/// The kind of the edit that a command begins, or of what it tells the open edit; other commands
/// have nothing but their own kind.
struct DetailOfCommand {
    core::TraceName operator()(const core::BeginEdit& begin) const { return kindOf(begin.edit); }
    core::TraceName operator()(const core::ExtendEdit& extend) const
    {
        return kindOf(extend.extension);
    }
    template <class Other> core::TraceName operator()(const Other&) const { return {}; }
};

} // namespace

CommandQueue::CommandQueue(EngineThread& thread)
    : m_thread(thread)
{
}

core::Ticket CommandQueue::submit(core::EngineCommand command)
{
    core::Ticket ticket = 0;
    {
        const std::lock_guard lock(m_mutex);
        ticket = ++m_lastTicket;
        m_waiting.push_back({.ticket = ticket, .command = std::move(command)});
        if (core::Trace::isOn())
            m_waiting.back().submitted = core::Trace::Clock::now();
    }
    m_thread.wake();
    return ticket;
}

std::vector<core::EngineResult> CommandQueue::collect()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_results, {});
}

void CommandQueue::finish()
{
    std::unique_lock lock(m_mutex);
    m_hurry = true;
    m_thread.wake();
    m_settled.wait(lock, [this] { return m_waiting.empty() && !m_busy && !m_progress.running; });
    m_hurry = false;
}

/// A rollback waits neither for steps nor for reading (takeNext()): it follows the slice that is
/// under way.
void CommandQueue::giveUp(core::Ticket ended)
{
    {
        const std::lock_guard lock(m_mutex);
        for (Waiting& each : m_waiting) {
            auto* end = std::get_if<core::EndEdit>(&each.command);
            if (end && each.ticket == ended)
                end->ending = core::Ending::Rollback;
        }
    }
    m_thread.wake();
}

void CommandQueue::setWakeUp(std::function<void()> wakeUp)
{
    const std::lock_guard lock(m_mutex);
    m_wakeUp = std::move(wakeUp);
}

core::GrowthProgress CommandQueue::growthProgress() const
{
    const std::lock_guard lock(m_mutex);
    return m_progress;
}

bool CommandQueue::takeNext(Waiting& next, EditTransaction* open)
{
    const std::lock_guard lock(m_mutex);
    if (m_waiting.empty())
        return false;
    if (open && isCommit(m_waiting.front().command)
        && (open->hasStepsLeft() || open->hasChangesToRead()))
        return false;
    // A command that is taken is answered, also where the engine has to tell a loss before.
    m_results.reserve(m_results.size() + 2);
    next = std::move(m_waiting.front());
    m_waiting.pop_front();
    m_busy = true;
    if (auto* extend = std::get_if<core::ExtendEdit>(&next.command); extend && open)
        takeMore(*extend, *open);
    return true;
}

bool CommandQueue::commitIsNext() const
{
    const std::lock_guard lock(m_mutex);
    return !m_waiting.empty() && isCommit(m_waiting.front().command);
}

/// What a pen told while something else was done is one piece of path: each costs as much as many.
void CommandQueue::takeMore(core::ExtendEdit& first, EditTransaction& open)
{
    for (int taken = 1; taken < extensionsAtOnce && !m_waiting.empty(); ++taken) {
        auto* next = std::get_if<core::ExtendEdit>(&m_waiting.front().command);
        if (!next || !open.join(first.extension, next->extension))
            return;
        m_waiting.pop_front();
    }
}

core::TraceSpan CommandQueue::traced(const Waiting& taken)
{
    core::TraceOptions options;
    if (core::Trace::isOn()) {
        options.detail = std::visit(DetailOfCommand(), taken.command);
        options.waitedMicroseconds = std::chrono::duration_cast<std::chrono::microseconds>(
            core::Trace::Clock::now() - taken.submitted)
                                         .count();
    }
    return {"engine", kindOf(taken.command), options};
}

void CommandQueue::deliver(core::EngineResult result)
{
    std::function<void()> wakeUp;
    {
        const std::lock_guard lock(m_mutex);
        m_results.push_back(std::move(result));
        wakeUp = m_wakeUp;
    }
    if (wakeUp)
        wakeUp();
}

void CommandQueue::publish(const core::GrowthProgress& progress)
{
    const std::lock_guard lock(m_mutex);
    m_progress = progress;
    m_busy = false;
    m_settled.notify_all();
}

bool CommandQueue::inHurry() const
{
    const std::lock_guard lock(m_mutex);
    return m_hurry;
}

bool CommandQueue::isDue(EngineThread::Clock::time_point moment)
{
    const std::lock_guard lock(m_mutex);
    if (m_hurry || EngineThread::Clock::now() >= moment)
        return true;
    m_thread.wakeAt(moment);
    return false;
}

} // namespace gpu
