// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionPlaces.h"

#include "core/base/files/ReadableFile.h"
#include "core/base/files/StagedFile.h"
#include "core/sessionfile/database/SessionUse.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace core {

Result<void> checkSessionPlace(const QString& path, bool replaceExisting)
{
    if (const Result<void> target = checkFileTarget(path, replaceExisting); !target)
        return target;
    if (const Result<void> replaced = checkReplacedSession(path); !replaced)
        return replaced;
    if (const QString stray = strayPartOf(path); !stray.isEmpty())
        return failure(ErrorCode::FileUnwritable, path,
            Clause::saying(
                "'%1' lies beside it, which belongs to another session; move it away", stray));
    return {};
}

Result<void> makeEmptySession(const QString& path)
{
    if (const Result<void> free = checkSessionPlace(path, false); !free)
        return free;
    QFile empty(path);
    if (!empty.open(QIODevice::WriteOnly | QIODevice::NewOnly,
            QFileDevice::ReadOwner | QFileDevice::WriteOwner))
        return failure(ErrorCode::FileUnwritable, path, empty.errorString());
    return {};
}

bool isSessionNameTaken(const QString& path)
{
    const QFileInfo there(path);
    return there.exists() || there.isSymLink() || !strayPartOf(path).isEmpty();
}

QString freeSessionName(const QString& path)
{
    const QFileInfo info(path);
    const QString ending = info.suffix().isEmpty() ? QString() : QLatin1Char('.') + info.suffix();
    QString free = path;
    for (int count = 2; isSessionNameTaken(free); ++count)
        free = info.absoluteDir().filePath(
            info.completeBaseName() + QStringLiteral(" (%1)").arg(count) + ending);
    return free;
}

Result<void> checkSessionToOpen(const QString& path, SessionAccess access)
{
    if (const Result<void> isFile = checkIsFile(path); !isFile)
        return isFile;
    const QFileInfo info(path);
    if (!info.isReadable())
        return failure(ErrorCode::FileUnreadable, path, Clause::saying("permission denied"));
    if (info.size() == 0)
        return failure(ErrorCode::FileTruncated, path, Clause::saying("it is empty"));
    if (access == SessionAccess::ReadWrite
        && !(info.isWritable() && QFileInfo(info.absolutePath()).isWritable()))
        return failure(ErrorCode::FileUnwritable, path,
            Clause::saying("a session is written while it is open; copy it to a folder of yours"));
    return {};
}

Result<void> checkOtherSessionAt(const QString& target, bool replaceExisting)
{
    if (QFileInfo::exists(target) && isSessionInUse(target))
        return failure(
            ErrorCode::FileUnwritable, target, Clause::saying("it is open in another window"));
    if (replaceExisting) {
        if (const Result<void> only = checkOnlySessionAt(target); !only)
            return only;
    }
    // What its program could not write any more would be taken for the new file's.
    if (isSessionUnfinished(target))
        return failure(ErrorCode::FileUnwritable, target,
            Clause::saying("it was not closed properly; open it once, or take another name"));
    return {};
}

bool isSessionNamedAt(const QString& path)
{
    const QFileInfo info(path);
    if (!info.isFile())
        return false;
    if (info.suffix().compare(QLatin1String("burin"), Qt::CaseInsensitive) == 0)
        return true;
    // One in use must not be opened as a plain file (SessionUse.h).
    if (isSessionInUse(path))
        return true;
    QFile file(path);
    return file.open(QIODevice::ReadOnly) && file.read(15) == "SQLite format 3";
}

} // namespace core
