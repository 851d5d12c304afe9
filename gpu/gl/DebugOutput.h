// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace gpu {

/// KHR_debug messages of the current context go to the log: errors as critical, the rest by their
/// severity. Tests fail on errors.
class DebugOutput {
public:
    /// On the context's thread, after it was made current.
    static void install();
    /// GL errors since the program began, over all contexts.
    [[nodiscard]] static int errorCount();
};

} // namespace gpu
