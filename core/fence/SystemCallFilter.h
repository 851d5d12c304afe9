// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core::fence {

/// From now on the kernel ends this process at any system call except those that allocate and free
/// memory, read the time, read from and write to @p descriptor, and end the process: no files, no
/// network, no processes, no code that was not loaded before.
///
/// @return false: this kernel or processor does not support such a filter
[[nodiscard]] bool filterSystemCalls(int descriptor);

} // namespace core::fence
