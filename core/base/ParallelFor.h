// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace core {

/// Calls work(0) … work(count - 1), each once, from as many threads as there are cores, and returns
/// when all are done. @p work must not throw and must not start another parallelFor.
void parallelFor(int count, const std::function<void(int)>& work);

} // namespace core
