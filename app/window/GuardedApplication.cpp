// SPDX-License-Identifier: Apache-2.0
#include "app/window/GuardedApplication.h"

#include "app/steps/Arguments.h"
#include "core/base/Guarded.h"
#include "core/base/trace/Trace.h"

#include <QMetaEnum>

#include <chrono>
#include <optional>
#include <utility>

namespace app {

namespace {

/// Shorter events are not worth a line of a trace.
constexpr std::chrono::milliseconds leastOfEvent{1};

} // namespace

bool GuardedApplication::notify(QObject* receiver, QEvent* event)
{
    try {
        std::optional<core::TraceSpan> span;
        if (core::Trace::isOn())
            span.emplace(core::TraceName("window"),
                core::TraceName::lasting(receiver->metaObject()->className()),
                core::TraceOptions{
                    .detail = core::TraceName::lasting(
                        QMetaEnum::fromType<QEvent::Type>().valueToKey(event->type())),
                    .least = leastOfEvent});
        return QApplication::notify(receiver, event);
    } catch (...) {
        escaped(core::errorBeingHandled());
        return true;
    }
}

void GuardedApplication::setRescue(std::function<void(const core::Error&)> rescue)
{
    m_rescue = std::move(rescue);
}

void GuardedApplication::escaped(const core::Error& error)
{
    static_cast<void>(reportFailure(error));
    if (!m_rescue || m_state == Rescue::UnderWay)
        return QCoreApplication::exit(EXIT_FAILURE);
    if (m_state == Rescue::Queued)
        return;
    m_state = Rescue::Queued;
    QMetaObject::invokeMethod(
        this,
        [this, error] {
            m_state = Rescue::UnderWay;
            m_rescue(error);
            m_state = Rescue::NotNeeded;
        },
        Qt::QueuedConnection);
}

} // namespace app
