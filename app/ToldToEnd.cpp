// SPDX-License-Identifier: Apache-2.0
#include "app/ToldToEnd.h"

#include "core/base/Guarded.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace app {

namespace {

constexpr int signals[] = {SIGTERM, SIGINT, SIGHUP};

// What a signal handler can reach.
volatile std::sig_atomic_t toTell = -1;

void onSignal(int number)
{
    const int error = errno;
    const auto byte = char(number);
    static_cast<void>(!::write(toTell, &byte, 1));
    errno = error;
}

} // namespace

ToldToEnd::ToldToEnd()
{
    if (::pipe2(m_ends, O_CLOEXEC) != 0
        || !core::guarded([this] { static_cast<void>(m_thread.emplace()); }))
        return;
    toTell = m_ends[1];
    m_thread->post([this] { watch(); }, [](const core::Error&) {});
    struct sigaction action { };
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;
    for (const int number : signals) {
        struct sigaction before { };
        // What the parent has ignored (nohup) stays so.
        if (::sigaction(number, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
            ::sigaction(number, &action, nullptr);
    }
}

ToldToEnd::~ToldToEnd()
{
    if (m_ends[0] < 0)
        return;
    for (const int number : signals) {
        struct sigaction before { };
        if (::sigaction(number, nullptr, &before) == 0 && before.sa_handler == onSignal)
            std::signal(number, SIG_DFL);
    }
    toTell = -1;
    {
        const std::lock_guard lock(m_mutex);
        m_done = true;
    }
    m_changed.notify_all();
    ::close(m_ends[1]);
    m_thread.reset();
    ::close(m_ends[0]);
}

void ToldToEnd::setClosing(std::function<void()> closing)
{
    const std::lock_guard lock(m_mutex);
    m_leaving = !closing;
    m_closing = std::move(closing);
}

int ToldToEnd::status(int usual) const
{
    const int number = m_signal;
    return usual != 0 && number != 0 ? 128 + number : usual;
}

void ToldToEnd::watch()
{
    // Of the two seconds that such an end may take.
    constexpr std::chrono::milliseconds moment(1200);
    char byte = 0;
    while (::read(m_ends[0], &byte, 1) < 0) {
        if (errno != EINTR)
            return;
    }
    if (byte == 0)
        return;
    m_signal = byte;
    m_progress.cancel();
    std::unique_lock lock(m_mutex);
    if (m_changed.wait_for(lock, moment, [this] { return m_done; }))
        return;
    // Whoever is about to close it is not disturbed.
    if (m_leaving)
        return m_changed.wait(lock, [this] { return m_done; });
    if (m_closing)
        m_closing();
    ::_exit(128 + byte);
}

} // namespace app
