// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace app {

/// Allows this process as many file handles as it may have, up to the usual 1024 (DCMTK waits for
/// connections by select(), which knows no more).
/// @return why a window cannot be opened, as one sentence: with fewer than 64 the libraries that
/// talk to the display end the program, or wait for ever. Empty: there are enough.
[[nodiscard]] QString whyNoWindowForHandles();

} // namespace app
