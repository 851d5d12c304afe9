// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/StagedFolder.h"

#include "core/base/files/StagedError.h"
#include "core/base/files/StagedFile.h"
#include "core/base/files/SystemFile.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace core {

namespace {

QString hiddenNameBeside(const QString& target)
{
    return temporaryNameBeside(QFileInfo(target).absoluteDir().filePath(QStringLiteral("folder")));
}

} // namespace

Result<StagedFolder> StagedFolder::create(const QString& target)
{
    StagedFolder staged;
    staged.m_target = QDir::cleanPath(QFileInfo(target).absoluteFilePath());
    const QFileInfo info(staged.m_target);
    if (info.isSymLink() || (info.exists() && !(info.isDir() && QDir(info.filePath()).isEmpty())))
        return failure(ErrorCode::FileExists, target);
    // The rest that a name can do wrong it does as the name of a file, too.
    if (!info.exists()) {
        if (const Result<void> fits = checkFileTarget(staged.m_target, false); !fits)
            return tl::unexpected(fits.error());
    }
    const QString path = hiddenNameBeside(staged.m_target);
    if (::mkdir(QFile::encodeName(path).constData(), 0777) != 0)
        return failure(ErrorCode::FileUnwritable, target, systemReason(errno));
    staged.m_path = path;
    return staged;
}

StagedFolder StagedFolder::adopt(const QString& path, const QString& target, bool replaceExisting)
{
    StagedFolder staged;
    staged.m_target = QDir::cleanPath(QFileInfo(target).absoluteFilePath());
    staged.m_path = path;
    staged.m_replaceExisting = replaceExisting;
    return staged;
}

StagedFolder::StagedFolder(StagedFolder&& other) noexcept
    : m_target(std::move(other.m_target))
    , m_path(std::exchange(other.m_path, QString()))
    , m_replaceExisting(other.m_replaceExisting)
{
}

StagedFolder& StagedFolder::operator=(StagedFolder&& other) noexcept
{
    std::swap(m_target, other.m_target);
    std::swap(m_path, other.m_path);
    std::swap(m_replaceExisting, other.m_replaceExisting);
    return *this;
}

StagedFolder::~StagedFolder()
{
    if (m_path.isEmpty())
        return;
    // It may have replaced a file. Of a link, what it leads to is not ours.
    if (const QFileInfo info(m_path); info.isSymLink() || !info.isDir())
        QFile::remove(m_path);
    else
        QDir(m_path).removeRecursively();
}

Result<void> StagedFolder::commit()
{
    QDirIterator files(m_path, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        if (!syncToDisk(files.next()))
            return failure(ErrorCode::FileUnwritable, m_target, systemReason(errno));
    }
    // Their names, too, before they take the place of others. Some network mounts cannot.
    syncToDisk(m_path);
    const QFileInfo there(m_target);
    if (there.isSymLink())
        return failure(ErrorCode::FileExists, m_target);
    if (m_replaceExisting && there.exists()) {
        if (const Result<void> exchanged = exchange(); !exchanged)
            return exchanged;
    } else {
        // An empty folder of that name gives way; one that has been filled meanwhile does not.
        if (std::rename(
                QFile::encodeName(m_path).constData(), QFile::encodeName(m_target).constData())
            != 0) {
            if (errno == EEXIST || errno == ENOTEMPTY || errno == ENOTDIR)
                return failure(ErrorCode::FileExists, m_target);
            return failure(ErrorCode::FileUnwritable, m_target, systemReason(errno));
        }
        m_path.clear();
    }
    // The folder is in place; one above it that cannot be synchronised is no error.
    syncToDisk(QFileInfo(m_target).absolutePath());
    return {};
}

/// The new folder takes the name and the old one the hidden name, at once where the file system can
/// do that.
Result<void> StagedFolder::exchange()
{
    const QByteArray from = QFile::encodeName(m_path);
    const QByteArray to = QFile::encodeName(m_target);
    if (::renameat2(AT_FDCWD, from.constData(), AT_FDCWD, to.constData(), RENAME_EXCHANGE) == 0)
        return {};
    int error = errno;
    const QString aside = hiddenNameBeside(m_target);
    const QByteArray old = QFile::encodeName(aside);
    const bool isUnknown = error == EINVAL || error == ENOSYS;
    if (isUnknown && std::rename(to.constData(), old.constData()) != 0) {
        error = errno;
    } else if (isUnknown) {
        if (std::rename(from.constData(), to.constData()) == 0) {
            m_path = aside;
            return {};
        }
        error = errno;
        if (std::rename(old.constData(), to.constData()) != 0)
            return failure(ErrorCode::FileUnwritable, m_target,
                leftElsewhere(systemReason(error), m_target, aside));
    }
    return failure(ErrorCode::FileUnwritable, m_target, systemReason(error));
}

} // namespace core
