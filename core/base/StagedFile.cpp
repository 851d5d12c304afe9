// SPDX-License-Identifier: Apache-2.0
#include "core/base/StagedFile.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUuid>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace core {

namespace {

QString systemReason(int error)
{
    return QString::fromLocal8Bit(std::strerror(error));
}

/// fsync() of a file or folder by name.
bool toDisk(const QString& path)
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

QString endingOf(const QString& fileName)
{
    if (fileName.endsWith(QLatin1String(".nii.gz"), Qt::CaseInsensitive))
        return QStringLiteral(".nii.gz");
    const QString suffix = QFileInfo(fileName).suffix();
    return suffix.isEmpty() ? QString() : QLatin1Char('.') + suffix;
}

} // namespace

Result<StagedFile> StagedFile::create(const QString& target, bool replaceExisting)
{
    const QFileInfo info(target);
    if (info.fileName().isEmpty() || info.isDir())
        return failure(ErrorCode::FileUnwritable, target, QStringLiteral("it is a folder"));
    if ((info.exists() || info.isSymLink()) && !replaceExisting)
        return failure(ErrorCode::FileExists, target);
    const QDir folder = info.absoluteDir();
    if (!folder.exists())
        return failure(ErrorCode::FileUnwritable, target,
            QStringLiteral("the folder %1 does not exist").arg(folder.path()));

    StagedFile staged;
    const QString path = folder.filePath(QStringLiteral(".burin-")
        + QUuid::createUuid().toString(QUuid::Id128).left(12) + endingOf(info.fileName()));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::NewOnly))
        return failure(ErrorCode::FileUnwritable, target, file.errorString());
    staged.m_path = path;
    staged.m_target = info.absoluteFilePath();
    staged.m_replaceExisting = replaceExisting;
    return staged;
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : m_path(std::exchange(other.m_path, QString()))
    , m_target(std::move(other.m_target))
    , m_replaceExisting(other.m_replaceExisting)
{
}

StagedFile& StagedFile::operator=(StagedFile&& other) noexcept
{
    std::swap(m_path, other.m_path);
    std::swap(m_target, other.m_target);
    std::swap(m_replaceExisting, other.m_replaceExisting);
    return *this;
}

StagedFile::~StagedFile()
{
    if (!m_path.isEmpty())
        QFile::remove(m_path);
}

Result<void> StagedFile::commit()
{
    if (!toDisk(m_path))
        return failure(ErrorCode::FileUnwritable, m_target, systemReason(errno));
    const QByteArray from = QFile::encodeName(m_path);
    const QByteArray to = QFile::encodeName(m_target);
    int result = -1;
    if (!m_replaceExisting) {
        result =
            ::renameat2(AT_FDCWD, from.constData(), AT_FDCWD, to.constData(), RENAME_NOREPLACE);
        if (result != 0 && errno == EEXIST)
            return failure(ErrorCode::FileExists, m_target);
        // Not every file system knows the flag; there the look just before the rename must do.
        if (result != 0 && errno == EINVAL && QFileInfo::exists(m_target))
            return failure(ErrorCode::FileExists, m_target);
    }
    if (result != 0 && std::rename(from.constData(), to.constData()) != 0)
        return failure(ErrorCode::FileUnwritable, m_target, systemReason(errno));
    m_path.clear();
    // The file is in place; a folder that cannot be synchronised (some network mounts) is no error.
    toDisk(QFileInfo(m_target).absolutePath());
    return {};
}

} // namespace core
