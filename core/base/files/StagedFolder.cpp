// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/StagedFolder.h"

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
    const QString path = temporaryNameBeside(info.absoluteDir().filePath(QStringLiteral("folder")));
    if (::mkdir(QFile::encodeName(path).constData(), 0777) != 0)
        return failure(ErrorCode::FileUnwritable, target, systemReason(errno));
    staged.m_path = path;
    return staged;
}

StagedFolder StagedFolder::adopt(const QString& path, const QString& target)
{
    StagedFolder staged;
    staged.m_target = QDir::cleanPath(QFileInfo(target).absoluteFilePath());
    staged.m_path = path;
    return staged;
}

StagedFolder::StagedFolder(StagedFolder&& other) noexcept
    : m_target(std::move(other.m_target))
    , m_path(std::exchange(other.m_path, QString()))
{
}

StagedFolder& StagedFolder::operator=(StagedFolder&& other) noexcept
{
    std::swap(m_target, other.m_target);
    std::swap(m_path, other.m_path);
    return *this;
}

StagedFolder::~StagedFolder()
{
    if (!m_path.isEmpty())
        QDir(m_path).removeRecursively();
}

Result<void> StagedFolder::commit()
{
    QDirIterator files(m_path, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        if (!syncToDisk(files.next()))
            return failure(ErrorCode::FileUnwritable, m_target, systemReason(errno));
    }
    // An empty folder of that name gives way; one that has been filled meanwhile does not.
    if (std::rename(QFile::encodeName(m_path).constData(), QFile::encodeName(m_target).constData())
        != 0) {
        if (errno == EEXIST || errno == ENOTEMPTY || errno == ENOTDIR)
            return failure(ErrorCode::FileExists, m_target);
        return failure(ErrorCode::FileUnwritable, m_target, systemReason(errno));
    }
    m_path.clear();
    // The folder is in place; one above it that cannot be synchronised is no error.
    syncToDisk(QFileInfo(m_target).absolutePath());
    return {};
}

} // namespace core
