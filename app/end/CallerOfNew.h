// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace app {

/// Loads what isLibraryCode() needs while there is memory. To be called once, at the beginning.
void prepareToNameCallers() noexcept;

/// Whether a request to operator new comes from the code of a library. Requests by the C++ library
/// are attributed to the code that called it.
/// @param caller the return address of operator new, which must be running on this thread
[[nodiscard]] bool isLibraryCode(const void* caller) noexcept;

} // namespace app
