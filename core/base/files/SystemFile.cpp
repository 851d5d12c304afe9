// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/SystemFile.h"

#include "core/base/ParallelFor.h"

#include <QFile>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
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

bool renameToFreeName(const QByteArray& from, const QByteArray& to)
{
    if (::renameat2(AT_FDCWD, from.constData(), AT_FDCWD, to.constData(), RENAME_NOREPLACE) == 0)
        return true;
    // Not every file system knows the flag; a second name does not replace anything either.
    if (errno != EINVAL && errno != ENOSYS)
        return false;
    if (::link(from.constData(), to.constData()) == 0) {
        if (::unlink(from.constData()) == 0)
            return true;
        const int error = errno;
        ::unlink(to.constData());
        errno = error;
        return false;
    }
    if (errno == EEXIST)
        return false;
    // Nor does every one know second names; there it must do to look just before.
    struct stat there { };
    if (::lstat(to.constData(), &there) == 0) {
        errno = EEXIST;
        return false;
    }
    return std::rename(from.constData(), to.constData()) == 0;
}

bool renameToFreeName(const QString& from, const QString& to)
{
    return renameToFreeName(QFile::encodeName(from), QFile::encodeName(to));
}

} // namespace core
