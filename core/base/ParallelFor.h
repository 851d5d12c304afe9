// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace core {

/// Calls work(0) … work(count - 1), each once, from as many threads as there are cores, and returns
/// when all are done. Where the system starts fewer threads, those do it, at least the calling one.
/// What @p work throws first is thrown here, and what has not begun by then is left undone.
/// @p work must not start another parallelFor.
/// @param threads at most, the calling one included; 0: as many as there are cores
void parallelFor(int count, const std::function<void(int)>& work, int threads = 0);

} // namespace core
