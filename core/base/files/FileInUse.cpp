// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/FileInUse.h"

#include <QFile>
#include <QFileInfo>

#include <map>
#include <mutex>
#include <utility>

#include <sys/stat.h>

namespace core {

namespace {

struct Registry {
    std::mutex mutex;
    std::multimap<FileIdentity, FileInUse::As> files; ///< under the mutex
};

/// Never destroyed: sessions may outlive other globals.
Registry& registry()
{
    static auto* all = new Registry;
    return *all;
}

} // namespace

std::optional<FileIdentity> FileIdentity::of(const QString& path)
{
    struct stat status { };
    FileIdentity identity;
    if (::stat(QFile::encodeName(path).constData(), &status) != 0) {
        const QFileInfo info(path);
        const QByteArray folder = QFile::encodeName(info.absolutePath());
        if (::stat(folder.constData(), &status) != 0)
            return std::nullopt;
        identity.m_name = info.fileName();
    }
    identity.m_device = status.st_dev;
    identity.m_inode = status.st_ino;
    return identity;
}

FileInUse::FileInUse(const QStringList& paths, As what)
    : m_what(what)
{
    for (const QString& path : paths) {
        if (const auto identity = FileIdentity::of(path))
            m_files.push_back(*identity);
    }
    const std::lock_guard lock(registry().mutex);
    for (const FileIdentity& file : m_files)
        registry().files.emplace(file, m_what);
}

FileInUse::FileInUse(FileInUse&& other) noexcept
    : m_files(std::exchange(other.m_files, {}))
    , m_what(other.m_what)
{
}

FileInUse& FileInUse::operator=(FileInUse&& other) noexcept
{
    std::swap(m_files, other.m_files);
    std::swap(m_what, other.m_what);
    return *this;
}

FileInUse::~FileInUse()
{
    const std::lock_guard lock(registry().mutex);
    for (const FileIdentity& file : m_files) {
        const auto [first, last] = registry().files.equal_range(file);
        for (auto it = first; it != last; ++it) {
            if (it->second == m_what) {
                registry().files.erase(it);
                break;
            }
        }
    }
}

std::optional<FileInUse::As> FileInUse::whatIs(const QString& path)
{
    const auto identity = FileIdentity::of(path);
    if (!identity)
        return std::nullopt;
    const std::lock_guard lock(registry().mutex);
    const auto found = registry().files.find(*identity);
    return found == registry().files.end() ? std::nullopt : std::optional(found->second);
}

Clause FileInUse::text(As what)
{
    switch (what) {
    case As::Study:
        return Clause::saying("it is a file of the study itself");
    case As::Session:
        return Clause::saying("it is a session that is open");
    case As::Recipe:
        return Clause::saying("it is the recipe");
    case As::Mask:
        return Clause::saying("it is a mask that is read");
    case As::List:
        return Clause::saying("it is the list of studies");
    }
    return {};
}

} // namespace core
