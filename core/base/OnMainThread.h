// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/HandedOver.h"

#include <QCoreApplication>
#include <QPointer>

#include <utility>

namespace core {

/// Wraps a function so that it can be called on any thread: the event loop of the program's main
/// thread then calls @p callback with copies of the arguments. After @p context was destroyed,
/// nothing is called any more. The context must live in the main thread, and this function must be
/// called there, too.
template <class Callback> [[nodiscard]] auto onMainThread(QObject* context, Callback callback)
{
    return
        [guard = QPointer<QObject>(context), callback = std::move(callback)](const auto&... what) {
            QMetaObject::invokeMethod(
                QCoreApplication::instance(),
                [guard, callback, what..., handed = HandedOver()] {
                    handed.takeOver();
                    if (guard)
                        callback(what...);
                },
                Qt::QueuedConnection);
        };
}

} // namespace core
