// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/DelayedEngine.h"

#include <algorithm>
#include <chrono>

namespace reference {

DelayedEngine::DelayedEngine(core::EditEngine& inner, std::uint32_t seed)
    : m_inner(inner)
    , m_random(seed)
{
}

DelayedEngine::~DelayedEngine()
{
    stopWaking();
    m_inner.setWakeUp({});
}

core::Result<void> DelayedEngine::openVolume(
    const glm::ivec3& size, std::span<const std::uint16_t> codes)
{
    finish();
    return m_inner.openVolume(size, codes);
}

core::Ticket DelayedEngine::submit(core::EngineCommand command)
{
    m_flushed = false;
    m_commands.push_back({++m_lastTicket, std::move(command)});
    if (m_random() % 4 == 0)
        forward(m_random() % (m_commands.size() + 1));
    m_holding = true;
    return m_lastTicket;
}

std::vector<core::EngineResult> DelayedEngine::collect()
{
    std::vector<core::EngineResult> ready;
    std::size_t count = 0;
    if (m_flushed) {
        takeResults();
        count = m_results.size();
    } else if (m_silentCollects > 0) {
        --m_silentCollects;
    } else {
        m_silentCollects = int(m_random() % 4);
        forward(m_random() % (m_commands.size() + 2));
        takeResults();
        count = m_random() % (m_results.size() + 2);
    }
    count = std::min(count, m_results.size());
    std::move(
        m_results.begin(), m_results.begin() + std::ptrdiff_t(count), std::back_inserter(ready));
    m_results.erase(m_results.begin(), m_results.begin() + std::ptrdiff_t(count));
    m_holding = !m_commands.empty() || !m_results.empty() || !m_outerTickets.empty();
    return ready;
}

void DelayedEngine::finish()
{
    forward(m_commands.size());
    m_inner.finish();
    takeResults();
    m_outerTickets.clear(); // what is left bore no result
    m_flushed = true;
    m_holding = !m_results.empty();
}

void DelayedEngine::setWakeUp(std::function<void()> wakeUp)
{
    stopWaking();
    m_wakeUp = std::move(wakeUp);
    if (!m_wakeUp)
        return;
    m_stop = false;
    m_waker = std::thread([this] {
        while (!m_stop) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            if (m_holding)
                m_wakeUp();
        }
    });
}

core::GrowthProgress DelayedEngine::growthProgress() const
{
    return m_inner.growthProgress();
}

void DelayedEngine::forward(std::size_t count)
{
    for (; count > 0 && !m_commands.empty(); --count) {
        Waiting waiting = std::move(m_commands.front());
        m_commands.pop_front();
        m_outerTickets[m_inner.submit(std::move(waiting.command))] = waiting.ticket;
    }
}

void DelayedEngine::takeResults()
{
    for (core::EngineResult& result : m_inner.collect()) {
        const auto known = m_outerTickets.find(result.ticket);
        result.ticket = known->second;
        // Results come in order, so nothing older will come any more.
        m_outerTickets.erase(m_outerTickets.begin(), std::next(known));
        m_results.push_back(std::move(result));
    }
}

void DelayedEngine::stopWaking()
{
    m_stop = true;
    if (m_waker.joinable())
        m_waker.join();
}

} // namespace reference
