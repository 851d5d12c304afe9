// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtGlobal>

namespace app {

/// To be alive while a QApplication is constructed: without a display Qt ends the program by
/// abort(). While an object of this class exists, that is reported in one sentence instead, and the
/// program exits with status 1.
class DisplayNeeded {
public:
    DisplayNeeded();
    ~DisplayNeeded();
    DisplayNeeded(const DisplayNeeded&) = delete;
    DisplayNeeded& operator=(const DisplayNeeded&) = delete;

private:
    QtMessageHandler m_before;
};

} // namespace app
