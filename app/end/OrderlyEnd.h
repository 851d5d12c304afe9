// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/end/EndSignals.h"

#include <QObject>

#include <functional>

namespace app {

/// Closes what is open when a program with an event loop is told to end. SIGTERM, SIGINT and SIGHUP
/// leave the event loop, as closing the last window does, with the exit status that shells give to
/// such an end (128 + signal). The user is not asked, since nobody may be there. If Qt ends the
/// program itself (the display is gone), what is open is closed, and the program exits with status
/// 1; SIGPIPE, which writing to such a display raises, is ignored.
///
/// One per process, on the GUI thread, while the event loop runs.
class OrderlyEnd : public QObject {
public:
    /// @param closesAll closes what is open, so that it is complete on disk; touches no window
    explicit OrderlyEnd(std::function<void()> closesAll);
    ~OrderlyEnd() override;
    OrderlyEnd(const OrderlyEnd&) = delete;
    OrderlyEnd& operator=(const OrderlyEnd&) = delete;

private:
    std::function<void()> m_closing;
    EndSignals m_signals;
};

} // namespace app
