// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

namespace core {

/// Writes what waits of every session file that this process has open, and leaves each as one file:
/// for a program that ends at once, from any thread, while the sessions' own are at work. Whatever
/// they want to write after it waits in memory, because of @p why, and goes with the program.
void closeSessionFiles(const Error& why);

} // namespace core
