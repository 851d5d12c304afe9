// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/StagedFile.h"

#include "core/base/files/FileInUse.h"
#include "core/base/files/StagedError.h"
#include "core/base/files/SystemFile.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUuid>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace core {

namespace {

QString endingOf(const QString& fileName)
{
    if (fileName.endsWith(QLatin1String(".nii.gz"), Qt::CaseInsensitive))
        return QStringLiteral(".nii.gz");
    const QString suffix = QFileInfo(fileName).suffix();
    return suffix.isEmpty() ? QString() : QLatin1Char('.') + suffix;
}

} // namespace

Result<void> checkFileTarget(const QString& target, bool replaceExisting, bool overSession)
{
    if (target.contains(QChar::Null))
        return failure(ErrorCode::FileUnwritable,
            QString(target).replace(QChar::Null, QLatin1String("\\0")),
            Clause::saying("no name holds a NUL character"));
    // What is not UTF-8 has become this sign, and would be written under another name.
    if (target.contains(QChar::ReplacementCharacter))
        return failure(ErrorCode::FileUnwritable, target, Clause::saying("its name is not UTF-8"));
    const QFileInfo info(target);
    if (info.fileName().isEmpty())
        return failure(ErrorCode::FileUnwritable, target, Clause::saying("it is a folder"));
    const QDir folder = info.absoluteDir();
    struct stat status { };
    if (::lstat(QFile::encodeName(target).constData(), &status) != 0) {
        if (errno == ENOENT && folder.exists())
            return {};
        return failure(ErrorCode::FileUnwritable, target,
            folder.exists() ? Clause(systemReason(errno))
                            : Clause::saying("the folder %1 does not exist", folder.path()));
    }
    if (S_ISDIR(status.st_mode))
        return failure(ErrorCode::FileUnwritable, target, Clause::saying("it is a folder"));
    if (S_ISLNK(status.st_mode))
        return failure(ErrorCode::FileUnwritable, target,
            Clause::saying("it is a link; name the file that it leads to"));
    if (!S_ISREG(status.st_mode))
        return failure(ErrorCode::FileUnwritable, target,
            Clause::saying("it is no plain file but a pipe, a socket or a device"));
    const std::optional<FileInUse::As> use = FileInUse::whatIs(target);
    if (use && !(overSession && use == FileInUse::As::Session))
        return failure(ErrorCode::FileUnwritable, target, FileInUse::text(*use));
    if (!replaceExisting)
        return failure(ErrorCode::FileExists, target);
    return {};
}

QString temporaryNameBeside(const QString& target)
{
    const QFileInfo info(target);
    return info.absoluteDir().filePath(QStringLiteral(".burin-")
        + QUuid::createUuid().toString(QUuid::Id128).left(12) + endingOf(info.fileName()));
}

Result<StagedFile> StagedFile::create(const QString& target, bool replaceExisting, bool overSession)
{
    if (const Result<void> checked = checkFileTarget(target, replaceExisting, overSession);
        !checked)
        return tl::unexpected(checked.error());
    StagedFile staged;
    const QString path = temporaryNameBeside(target);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::NewOnly))
        return failure(ErrorCode::FileUnwritable, target, file.errorString());
    staged.m_path = path;
    staged.m_target = QFileInfo(target).absoluteFilePath();
    staged.m_replaceExisting = replaceExisting;
    staged.m_overSession = overSession;
    return staged;
}

StagedFile StagedFile::adopt(const QString& path, const QString& target, bool replaceExisting)
{
    StagedFile staged;
    staged.m_path = QFileInfo(path).absoluteFilePath();
    staged.m_target = QFileInfo(target).absoluteFilePath();
    staged.m_replaceExisting = replaceExisting;
    staged.m_isAdopted = true;
    return staged;
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : m_path(std::exchange(other.m_path, QString()))
    , m_before(std::move(other.m_before))
    , m_target(std::move(other.m_target))
    , m_astray(std::move(other.m_astray))
    , m_made(std::move(other.m_made))
    , m_replaceExisting(other.m_replaceExisting)
    , m_overSession(other.m_overSession)
    , m_isAdopted(other.m_isAdopted)
    , m_committed(other.m_committed)
{
}

StagedFile& StagedFile::operator=(StagedFile&& other) noexcept
{
    std::swap(m_path, other.m_path);
    std::swap(m_before, other.m_before);
    std::swap(m_target, other.m_target);
    std::swap(m_astray, other.m_astray);
    std::swap(m_made, other.m_made);
    std::swap(m_replaceExisting, other.m_replaceExisting);
    std::swap(m_overSession, other.m_overSession);
    std::swap(m_isAdopted, other.m_isAdopted);
    std::swap(m_committed, other.m_committed);
    return *this;
}

StagedFile::~StagedFile()
{
    if (m_path.isEmpty() || (m_isAdopted && !m_committed))
        return; // there is no other copy of an adopted file
    // With what SQLite kept beside it, where it was a session whose disk failed.
    for (const char* part : {"", "-wal", "-shm", "-journal"})
        QFile::remove(m_path + QLatin1String(part));
}

Result<void> StagedFile::commit()
{
    // A session whose disk failed as it was closed would lose what it has beside it.
    for (const char* part : {"-wal", "-journal"}) {
        if (QFileInfo(m_path + QLatin1String(part)).size() > 0)
            return failure(ErrorCode::FileUnwritable, m_target,
                Clause::saying("it could not be closed as one file"));
    }
    if (!syncToDisk(m_path))
        return failure(ErrorCode::FileUnwritable, m_target, systemReason(errno));
    // What lies there may be another thing by now.
    if (const Result<void> still = checkFileTarget(m_target, m_replaceExisting, m_overSession);
        !still)
        return still;
    m_made = FollowedFile(m_path);
    // Nothing may be thrown once it has its name.
    const QByteArray from = QFile::encodeName(m_path);
    const QByteArray to = QFile::encodeName(m_target);
    const QString folder = QFileInfo(m_target).absolutePath();
    m_before = m_path;
    if (m_replaceExisting && QFileInfo::exists(m_target)) {
        if (!exchange(from, to)) {
            const QString why = systemReason(errno);
            return failure(ErrorCode::FileUnwritable, m_target,
                m_astray.isEmpty() ? Clause(why) : leftElsewhere(why, m_target, m_astray));
        }
    } else {
        if (!renameToFreeName(from, to))
            return errno == EEXIST
                ? failure(ErrorCode::FileExists, m_target)
                : failure(ErrorCode::FileUnwritable, m_target, systemReason(errno));
        m_path.clear();
    }
    m_committed = true;
    // The file is in place; a folder that cannot be synchronised (some network mounts) is no error.
    syncToDisk(folder);
    return {};
}

/// The new file takes the name and the old one the temporary name, at once where the file system
/// can do that. The target's name leads to one of them all the while, or to none for a moment on
/// file systems that do not know second names either.
bool StagedFile::exchange(const QByteArray& from, const QByteArray& to)
{
    if (::renameat2(AT_FDCWD, from.constData(), AT_FDCWD, to.constData(), RENAME_EXCHANGE) == 0)
        return true;
    if (errno != EINVAL && errno != ENOSYS)
        return false;
    const QString aside = temporaryNameBeside(m_target);
    const QByteArray old = QFile::encodeName(aside);
    const bool isSecondName = ::link(to.constData(), old.constData()) == 0;
    if (!isSecondName && std::rename(to.constData(), old.constData()) != 0)
        return false;
    if (std::rename(from.constData(), to.constData()) != 0) {
        const int error = errno;
        if (isSecondName)
            ::unlink(old.constData());
        else if (std::rename(old.constData(), to.constData()) != 0)
            m_astray = aside;
        errno = error;
        return false;
    }
    m_path = aside;
    return true;
}

QString StagedFile::takeBack()
{
    const QByteArray now = QFile::encodeName(m_path);
    const QByteArray before = QFile::encodeName(m_before);
    const QByteArray target = QFile::encodeName(m_target);
    const QString folder = QFileInfo(m_target).absolutePath();
    if (!std::exchange(m_committed, false))
        return {};
    // What another program has put there meanwhile is not ours to take away.
    if (!m_made.isAt(m_target)) {
        m_isAdopted = true;
        return m_path;
    }
    QString left;
    if (!m_path.isEmpty()) {
        if (!exchange(now, target))
            left = std::exchange(m_path, std::exchange(m_astray, QString()));
    } else if (std::rename(target.constData(), before.constData()) == 0) {
        m_path = m_before;
    } else if (!m_isAdopted) {
        QFile::remove(m_target);
    }
    syncToDisk(folder);
    return left;
}

} // namespace core
