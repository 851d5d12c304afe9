// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/ReadableFile.h"

#include <QFile>
#include <QFileInfo>

#include <sys/stat.h>

namespace core {

Result<void> checkReadsToAnEnd(const QString& path)
{
    if (path.contains(QChar::Null))
        return failure(ErrorCode::FileUnreadable,
            QString(path).replace(QChar::Null, QLatin1String("\\0")),
            Clause::saying("no name holds a NUL character"));
    struct stat status { };
    if (::stat(QFile::encodeName(path).constData(), &status) != 0)
        return {};
    if (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode))
        return {};
    return failure(ErrorCode::FileUnreadable, path,
        Clause::saying("it is no plain file but a pipe, a socket or a device"));
}

Result<void> checkIsFile(const QString& path)
{
    const QFileInfo info(path);
    if (!info.exists())
        return failure(ErrorCode::FileNotFound, path);
    if (info.isDir())
        return failure(ErrorCode::FileUnreadable, path, Clause::saying("it is a folder"));
    return checkReadsToAnEnd(path);
}

} // namespace core
