// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/SystemFile.h"

#include "core/base/ParallelFor.h"

#include <QFile>

#include <atomic>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace core {

QString systemReason(int error)
{
    return QString::fromLocal8Bit(std::strerror(error));
}

bool syncToDisk(const QString& path)
{
    const int descriptor = ::open(QFile::encodeName(path).constData(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        return false;
    const bool done = ::fsync(descriptor) == 0;
    const int error = errno;
    ::close(descriptor);
    errno = error;
    return done;
}

int syncAllToDisk(const QStringList& paths)
{
    std::atomic<int> trouble = 0;
    constexpr int atOnce = 8;
    parallelFor(
        int(paths.size()),
        [&](int i) {
            if (!syncToDisk(paths[i]))
                trouble = errno;
        },
        atOnce);
    return trouble;
}

} // namespace core
