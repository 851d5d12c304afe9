// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtGlobal>

namespace app {

/// Around the making of a QApplication: where there is no display that a window can be shown on, Qt
/// ends the program by abort(). Meanwhile that is said in one sentence, and it ends with status 1.
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
