// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <functional>

namespace core {

/// Writes what waits of every session file that this process has open, and leaves each as one file:
/// for a program that ends at once, from any thread, while the sessions' own are at work. Whatever
/// they want to write after it waits in memory, because of @p why, and goes with the program.
void closeSessionFiles(const Error& why);

/// While it lives closeSessionFiles() closes a session file by @p close.
class ClosableSessionFile {
public:
    explicit ClosableSessionFile(std::function<void(const Error& why)> close);
    ClosableSessionFile(const ClosableSessionFile&) = delete;
    ClosableSessionFile& operator=(const ClosableSessionFile&) = delete;
    /// Waits until it is closed where that is under way.
    ~ClosableSessionFile();
};

} // namespace core
