// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QPointer>

#include <utility>

namespace core {

/// Wraps a function so that it can be called on any thread: the event loop of the program's first
/// thread then calls @p told with copies of the arguments. Nothing is called after @p context was
/// destroyed. The context lives in the first thread, where this function must be called too.
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
