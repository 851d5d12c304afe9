// SPDX-License-Identifier: Apache-2.0
#include "app/OrderlyEnd.h"

#include <QCoreApplication>
#include <QSocketNotifier>
#include <QThread>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace app {

namespace {

constexpr int signals[] = {SIGTERM, SIGINT, SIGHUP};

// What a signal handler and an exit handler can reach.
volatile std::sig_atomic_t toTell = -1;
OrderlyEnd* current = nullptr;
std::function<void()>* closing = nullptr;
QtMessageHandler messagesBefore = nullptr;

void onSignal(int number)
{
    const int error = errno;
    const auto byte = char(number);
    // The pipe is full where many came at once; one is enough.
    static_cast<void>(!::write(toTell, &byte, 1));
    errno = error;
}

void closeAndEnd()
{
    if (!closing || !*closing)
        return;
    std::exchange(*closing, {})();
    // Threads are at work, and windows without a display are not to be taken apart.
    ::_exit(EXIT_FAILURE);
}

/// Qt says so and calls exit() then. Here everything is alive still; in exit() globals of libraries
/// go that were made after the handler was registered, and closing a session needs some.
void onMessage(QtMsgType type, const QMessageLogContext& context, const QString& message)
{
    if (messagesBefore)
        messagesBefore(type, context, message);
    const bool displayIsGone = message.startsWith(QLatin1String("The X11 connection broke"))
        || message.startsWith(QLatin1String("The Wayland connection broke"));
    if (displayIsGone && qApp && QThread::currentThread() == qApp->thread())
        closeAndEnd();
}

} // namespace

OrderlyEnd::OrderlyEnd(std::function<void()> closesAll)
    : m_closing(std::move(closesAll))
{
    Q_ASSERT(!current);
    current = this;
    closing = &m_closing;
    static const int registered = std::atexit(closeAndEnd);
    static_cast<void>(registered);
    messagesBefore = qInstallMessageHandler(onMessage);
    if (::pipe2(m_ends, O_CLOEXEC | O_NONBLOCK) != 0)
        return;
    toTell = m_ends[1];
    auto* notifier = new QSocketNotifier(m_ends[0], QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, [this] { take(); });
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

OrderlyEnd::~OrderlyEnd()
{
    qInstallMessageHandler(messagesBefore);
    closing = nullptr;
    current = nullptr;
    if (m_ends[0] < 0)
        return;
    for (const int number : signals)
        std::signal(number, SIG_DFL);
    toTell = -1;
    ::close(m_ends[0]);
    ::close(m_ends[1]);
}

void OrderlyEnd::take()
{
    char number = 0;
    if (::read(m_ends[0], &number, 1) == 1)
        QCoreApplication::exit(128 + number);
}

} // namespace app
