// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/FollowedFile.h"

#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace core {

namespace {

/// The Desktop Trash Can specification; and what NFS keeps of a deleted file while it is open.
bool isDeleted(const QString& path)
{
    static const QRegularExpression trash(
        QStringLiteral("/(Trash|\\.Trash-[0-9]+|\\.Trash/[0-9]+)/files/"));
    return trash.match(path).hasMatch() || QFileInfo(path).fileName().startsWith(u".nfs");
}

} // namespace

FollowedFile::FollowedFile(const QString& path)
    : m_descriptor(::open(QFile::encodeName(path).constData(), O_PATH | O_CLOEXEC))
{
}

FollowedFile::FollowedFile(FollowedFile&& other) noexcept
    : m_descriptor(std::exchange(other.m_descriptor, -1))
{
}

FollowedFile& FollowedFile::operator=(FollowedFile&& other) noexcept
{
    std::swap(m_descriptor, other.m_descriptor);
    return *this;
}

FollowedFile::~FollowedFile()
{
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

bool FollowedFile::isAt(const QString& path) const
{
    struct stat followed { };
    if (m_descriptor < 0 || ::fstat(m_descriptor, &followed) != 0)
        return true;
    struct stat there { };
    if (::stat(QFile::encodeName(path).constData(), &there) != 0)
        return errno != ENOENT && errno != ENOTDIR;
    return there.st_dev == followed.st_dev && there.st_ino == followed.st_ino;
}

QString FollowedFile::path() const
{
    if (m_descriptor < 0)
        return {};
    // proc(5): the text has " (deleted)" behind it when no name is left, which may be part of one.
    const QString path = QFile::symLinkTarget(QStringLiteral("/proc/self/fd/%1").arg(m_descriptor));
    return QFile::exists(path) && isAt(path) && !isDeleted(path) ? path : QString();
}

} // namespace core
