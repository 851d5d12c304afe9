// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/end/EndSignals.h"

#include <QObject>

#include <functional>

namespace app {

/// However a program with an event loop is told to end, what is open is closed. SIGTERM, SIGINT and
/// SIGHUP leave the event loop, as closing the last window does, with the exit status that shells
/// give to such an end (128 + signal); nothing is asked, since nobody may be there. When Qt ends
/// the program itself (the display is gone), what is open is closed, and the program ends there
/// with status 1.
///
/// One per process, on the GUI thread, while the event loop runs.
class OrderlyEnd : public QObject {
public:
    /// @param closesAll leaves what is open whole on disk; touches no window
    explicit OrderlyEnd(std::function<void()> closesAll);
    ~OrderlyEnd() override;
    OrderlyEnd(const OrderlyEnd&) = delete;
    OrderlyEnd& operator=(const OrderlyEnd&) = delete;

private:
    std::function<void()> m_closing;
    EndSignals m_signals;
};

} // namespace app
