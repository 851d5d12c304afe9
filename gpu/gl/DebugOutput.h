// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace gpu {

/// Sends KHR_debug messages of the current context to the log: errors as critical, the others by
/// their severity. Tests fail on errors.
class DebugOutput {
public:
    /// Call it on the context's thread, after the context was made current.
    static void install();
    /// The number of GL errors since the program began, over all contexts.
    [[nodiscard]] static int errorCount();
};

} // namespace gpu
