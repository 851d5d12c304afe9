// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace gpu {

/// Whether the driver of the current context computes on the processor (Mesa's llvmpipe or
/// softpipe): what it stores then lies in the program's own memory.
[[nodiscard]] bool isSoftwareDriver();

} // namespace gpu
