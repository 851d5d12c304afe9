// SPDX-License-Identifier: Apache-2.0
#include "app/end/OrderlyEnd.h"

#include <QCoreApplication>
#include <QSocketNotifier>
#include <QThread>

#include <csignal>
#include <cstdlib>
#include <utility>

#include <unistd.h>

namespace app {

namespace {

// What an exit handler can reach.
OrderlyEnd* current = nullptr;
std::function<void()>* closing = nullptr;
QtMessageHandler messagesBefore = nullptr;

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
    , m_signals(EndSignals::Reading::ReturnsAtOnce)
{
    Q_ASSERT(!current);
    current = this;
    // What is sent to a display that has just gone would end the program before Qt notices.
    std::signal(SIGPIPE, SIG_IGN);
    closing = &m_closing;
    static const int registered = std::atexit(closeAndEnd);
    static_cast<void>(registered);
    messagesBefore = qInstallMessageHandler(onMessage);
    if (!m_signals.areCaught())
        return;
    auto* notifier = new QSocketNotifier(m_signals.descriptor(), QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, [this] {
        if (const int number = m_signals.read(); number != 0)
            QCoreApplication::exit(128 + number);
    });
}

OrderlyEnd::~OrderlyEnd()
{
    qInstallMessageHandler(messagesBefore);
    std::signal(SIGPIPE, SIG_DFL);
    closing = nullptr;
    current = nullptr;
}

} // namespace app
