// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"

#include <QApplication>

#include <functional>

namespace app {

/// Nothing that is thrown while an event is handled goes through Qt's event loop: it is told to the
/// rescue, once the stack is unwound. Where that throws as well, the program ends with status 1.
class GuardedApplication : public QApplication {
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;

    /// @param rescue closes what is open and says why. Lives as long as this or until replaced
    void setRescue(std::function<void(const core::Error&)> rescue);

private:
    void escaped(const core::Error& error);

    std::function<void(const core::Error&)> m_rescue;
    enum class Rescue { NotNeeded, Queued, UnderWay } m_state = Rescue::NotNeeded;
};

} // namespace app
