// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace gpu {

/// While an object of this class exists, its thread is inside the graphics driver. No exception may
/// leave the driver: the locks that it holds would never be released, and the next call that needs
/// one of them would wait for ever. The program's operator new therefore ends the program where it
/// would throw into the driver (app/Allocation.cpp).
///
/// They may be nested. Costs nothing worth measuring.
class CallsDriver {
public:
    CallsDriver() noexcept;
    ~CallsDriver();
    CallsDriver(const CallsDriver&) = delete;
    CallsDriver& operator=(const CallsDriver&) = delete;

    /// Whether such an object exists on the calling thread.
    [[nodiscard]] static bool onThisThread() noexcept;
};

} // namespace gpu
