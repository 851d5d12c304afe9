// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/pacing/PacedApplication.h"

#include <QEvent>
#include <QMetaEnum>
#include <QThread>

#include <utility>

namespace bench {

std::vector<PacedApplication::Handled> PacedApplication::takeHandled()
{
    return std::exchange(m_handled, {});
}

void PacedApplication::setPainted(std::function<void(const QObject& widget)> painted)
{
    m_painted = std::move(painted);
}

bool PacedApplication::notify(QObject* receiver, QEvent* event)
{
    // Other threads have events, too, which hold nobody up.
    if (QThread::currentThread() != thread())
        return GuardedApplication::notify(receiver, event);
    // Afterwards neither need be there any more.
    const QEvent::Type type = event->type();
    const char* const name = receiver->metaObject()->className();
    const Clock::time_point begin = Clock::now();
    ++m_depth;
    const bool handled = GuardedApplication::notify(receiver, event);
    --m_depth;
    if (type == QEvent::Paint && m_painted)
        m_painted(*receiver);
    const Clock::time_point end = Clock::now();
    if (m_depth == 0 && end - begin >= leastNoted) {
        const char* const word = QMetaEnum::fromType<QEvent::Type>().valueToKey(type);
        m_handled.push_back({.begin = begin,
            .end = end,
            .name = QStringLiteral("%1, %2").arg(
                QLatin1String(name), QLatin1String(word ? word : "an event of its own"))});
    }
    return handled;
}

} // namespace bench
