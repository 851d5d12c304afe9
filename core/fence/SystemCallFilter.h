// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core::fence {

/// From now on the kernel ends this process at any system call but those that take and give memory,
/// tell the time, read from and write to @p descriptor, and end the process: no files, no network,
/// no processes, no code that was not loaded before.
///
/// @return false: this kernel or processor has no such filter
[[nodiscard]] bool filterSystemCalls(int descriptor);

} // namespace core::fence
