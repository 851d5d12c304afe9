// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QPointer>

#include <utility>

namespace core {

/// For those who answer on a thread of their own: what it returns may be called on any thread, and
/// has @p told called with copies of its arguments by the event loop of the program's first thread.
/// Nothing is told once @p context is gone, which lives in that thread, where this is called, too.
template <class Told> [[nodiscard]] auto toldHere(QObject* context, Told told)
{
    return [guard = QPointer<QObject>(context), told = std::move(told)](const auto&... what) {
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [guard, told, what...] {
                if (guard)
                    told(what...);
            },
            Qt::QueuedConnection);
    };
}

} // namespace core
