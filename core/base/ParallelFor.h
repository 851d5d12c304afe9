// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace core {

/// Calls work(0) … work(count - 1), each once, on as many threads as there are cores, and returns
/// when all are done. If the system starts fewer threads, these do the work; the calling thread
/// always takes part. The first exception of @p work is rethrown here, and calls that have not
/// begun by then are skipped. @p work must not call parallelFor.
/// @param threads greatest number, including the calling one; 0: as many as there are cores
void parallelFor(int count, const std::function<void(int)>& work, int threads = 0);

} // namespace core
