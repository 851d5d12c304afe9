// SPDX-License-Identifier: Apache-2.0
#include "app/end/EndSignals.h"

#include <cerrno>
#include <csignal>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace app {

namespace {

constexpr int signals[] = {SIGTERM, SIGINT, SIGHUP};

// What a signal handler can reach.
volatile std::sig_atomic_t writeEnd = -1;

void onSignal(int number)
{
    const int error = errno;
    const auto byte = char(number);
    // The pipe is full where many came at once; one is enough.
    static_cast<void>(!::write(writeEnd, &byte, 1));
    errno = error;
}

} // namespace

EndSignals::EndSignals(Reading reading)
{
    const int flags = reading == Reading::Waits ? O_CLOEXEC : O_CLOEXEC | O_NONBLOCK;
    if (::pipe2(m_ends, flags) != 0)
        return;
    writeEnd = m_ends[1];
    struct sigaction action { };
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;
    for (const int number : signals) {
        struct sigaction before { };
        if (::sigaction(number, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
            ::sigaction(number, &action, nullptr);
    }
}

EndSignals::~EndSignals()
{
    stop();
    if (m_ends[0] >= 0)
        ::close(m_ends[0]);
}

int EndSignals::read() const
{
    char byte = 0;
    ssize_t count = -1;
    do
        count = ::read(m_ends[0], &byte, 1);
    while (count < 0 && errno == EINTR);
    return count == 1 ? int(byte) : 0;
}

void EndSignals::stop()
{
    if (m_ends[1] < 0)
        return;
    for (const int number : signals) {
        struct sigaction now { };
        if (::sigaction(number, nullptr, &now) == 0 && now.sa_handler == onSignal)
            std::signal(number, SIG_DFL);
    }
    writeEnd = -1;
    ::close(std::exchange(m_ends[1], -1));
}

} // namespace app
