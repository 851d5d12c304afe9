// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

namespace test {

/// An X server (Xvfb, 2560 × 1440, 24 bits) that only this process and its children use: DISPLAY
/// names it while the object lives. It ends with the object, and with the process, however that
/// ends. If it cannot be started the process exits with a message and status 1. Make it on the main
/// thread, before the first connection to a display.
class OwnDisplay {
public:
    OwnDisplay();
    ~OwnDisplay();
    OwnDisplay(const OwnDisplay&) = delete;
    OwnDisplay& operator=(const OwnDisplay&) = delete;

private:
    pid_t m_server = -1;
};

} // namespace test
