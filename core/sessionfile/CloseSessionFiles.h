// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <functional>

namespace core {

/// Writes what is still waiting of every session file that this process has open, and closes each
/// as a single file. It is for a program that ends at once; any thread may call it while the
/// sessions' own threads are working. What sessions want to write afterwards waits in memory, with
/// @p why as the reason, and is lost when the program ends.
void closeSessionFiles(const Error& why);

/// While an object exists, closeSessionFiles() calls its @p close.
class ClosableSessionFile {
public:
    explicit ClosableSessionFile(std::function<void(const Error& why)> close);
    ClosableSessionFile(const ClosableSessionFile&) = delete;
    ClosableSessionFile& operator=(const ClosableSessionFile&) = delete;
    /// Waits until the file is closed if that has begun.
    ~ClosableSessionFile();
};

} // namespace core
