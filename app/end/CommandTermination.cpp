// SPDX-License-Identifier: Apache-2.0
#include "app/end/CommandTermination.h"

#include "core/base/Guarded.h"

#include <chrono>
#include <utility>

#include <unistd.h>

namespace app {

CommandTermination::CommandTermination()
    : m_signals(EndSignals::Reading::Waits)
{
    const auto started = core::guarded([this] { static_cast<void>(m_thread.emplace()); });
    if (started && m_signals.areCaught())
        m_thread->post([this] { watch(); }, [](const core::Error&) {});
    else
        m_signals.stop();
}

CommandTermination::~CommandTermination()
{
    {
        const std::lock_guard lock(m_mutex);
        m_done = true;
    }
    m_changed.notify_all();
    m_signals.stop();
    m_thread.reset();
}

void CommandTermination::setClosing(std::function<void()> closing)
{
    const std::lock_guard lock(m_mutex);
    m_leaving = !closing;
    m_closing = std::move(closing);
}

int CommandTermination::status(int usual) const
{
    const int number = m_signal;
    return usual != 0 && number != 0 ? 128 + number : usual;
}

void CommandTermination::watch()
{
    // Of the two seconds that such an end may take.
    constexpr std::chrono::milliseconds moment(1200);
    const int number = m_signals.read();
    if (number == 0)
        return;
    m_signal = number;
    m_progress.cancel();
    std::unique_lock lock(m_mutex);
    if (m_changed.wait_for(lock, moment, [this] { return m_done; }))
        return;
    // Whoever is about to close it is not disturbed.
    if (m_leaving)
        return m_changed.wait(lock, [this] { return m_done; });
    if (m_closing)
        m_closing();
    ::_exit(128 + number);
}

} // namespace app
