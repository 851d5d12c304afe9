// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/CloseSessionFiles.h"

#include <map>
#include <mutex>
#include <utility>

namespace core {

namespace {

struct OpenFiles {
    std::mutex mutex;
    std::map<const ClosableSessionFile*, std::function<void(const Error&)>>
        closing; ///< under the mutex
};

/// Never destroyed: sessions may outlive other globals.
OpenFiles& openFiles()
{
    static auto* all = new OpenFiles;
    return *all;
}

} // namespace

void closeSessionFiles(const Error& why)
{
    const std::lock_guard lock(openFiles().mutex);
    for (const auto& [file, close] : openFiles().closing)
        close(why);
}

ClosableSessionFile::ClosableSessionFile(std::function<void(const Error& why)> close)
{
    const std::lock_guard lock(openFiles().mutex);
    openFiles().closing[this] = std::move(close);
}

ClosableSessionFile::~ClosableSessionFile()
{
    const std::lock_guard lock(openFiles().mutex);
    openFiles().closing.erase(this);
}

} // namespace core
