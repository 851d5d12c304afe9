// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace app {

/// Loads what isLibraryCode() needs while there is memory. To be called once, at the beginning.
void prepareToNameCallers() noexcept;

/// Whether memory that operator new is asked for is wanted by the code of another library than the
/// C++ library, which is taken to ask for its own caller.
/// @param caller the return address of operator new, which must be under way on this thread
[[nodiscard]] bool isLibraryCode(const void* caller) noexcept;

} // namespace app
