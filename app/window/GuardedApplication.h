// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"

#include <QApplication>

#include <functional>

namespace app {

/// An application that catches what is thrown while an event is handled, so that no exception
/// passes through Qt's event loop. The exception is passed to the rescue function, once the stack
/// is unwound. If that throws as well, the program exits with status 1.
class GuardedApplication : public QApplication {
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;

    /// @param rescue closes what is open and tells the user why; must live until it is replaced or
    /// this object ends
    void setRescue(std::function<void(const core::Error&)> rescue);

private:
    void escaped(const core::Error& error);

    std::function<void(const core::Error&)> m_rescue;
    enum class Rescue { NotNeeded, Queued, UnderWay } m_state = Rescue::NotNeeded;
};

} // namespace app
