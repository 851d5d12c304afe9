// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/FolderCache.h"

#include "core/base/files/PrivateFolder.h"
#include "core/base/files/TakeLock.h"

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <atomic>
#include <tuple>
#include <utility>

namespace core {

namespace {

const QString openMark = QStringLiteral(".open-");
const QString usedMark = QStringLiteral(".used");
const QString gatheringMark = QStringLiteral(".burin-download");

qint64 bytesIn(const QString& folder)
{
    qint64 bytes = 0;
    QDirIterator walk(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        walk.next();
        bytes += walk.fileInfo().size();
    }
    return bytes;
}

/// The mark beside an entry whose time says when it was used.
QString usedFile(const QString& path)
{
    return path + usedMark;
}

} // namespace

FolderCache::FolderCache(QString folder)
    : m_folder(QDir::cleanPath(std::move(folder)))
{
}

Result<void> FolderCache::prepare() const
{
    if (!makePrivateFolder(m_folder))
        return failure(ErrorCode::FileUnwritable, m_folder);
    return {};
}

QString FolderCache::gatheringPlaceOf(const QString& path)
{
    const QFileInfo info(path);
    return info.dir().filePath(u'.' + info.fileName() + gatheringMark);
}

QString FolderCache::entryOf(const QString& path) const
{
    const QString absolute = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    const QString folder = QDir::cleanPath(QFileInfo(m_folder).absoluteFilePath()) + u'/';
    if (!absolute.startsWith(folder))
        return {};
    const QString name = absolute.mid(folder.size()).section(u'/', 0, 0);
    return name.isEmpty() ? QString() : folder + name;
}

std::vector<FolderCache::Entry> FolderCache::entries() const
{
    std::vector<Entry> all;
    const QDir folder(m_folder);
    // What a link leads to is not the cache's, and may be anybody's.
    for (const QString& name :
        folder.entryList(QDir::Dirs | QDir::NoSymLinks | QDir::NoDotAndDotDot)) {
        const QString path = folder.filePath(name);
        const QFileInfo used(usedFile(path));
        all.push_back({.path = path,
            .bytes = bytesIn(path),
            .used = used.exists() ? used.lastModified() : QFileInfo(path).lastModified()});
    }
    std::sort(all.begin(), all.end(), [](const Entry& a, const Entry& b) {
        return std::tie(b.used, a.path) < std::tie(a.used, b.path);
    });
    return all;
}

qint64 FolderCache::bytes() const
{
    return bytesIn(m_folder);
}

void FolderCache::touch(const QString& path) const
{
    QFile mark(usedFile(path));
    if (mark.open(QIODevice::ReadWrite))
        mark.setFileTime(QDateTime::currentDateTimeUtc(), QFileDevice::FileModificationTime);
}

FolderCache::Hold FolderCache::hold(const QString& path) const
{
    if (!QFileInfo(path).isDir())
        return nullptr;
    // One for each holder: they do not wait for each other.
    static std::atomic<int> number = 0;
    auto lock = std::make_unique<QLockFile>(path + openMark
        + QStringLiteral("%1-%2").arg(QCoreApplication::applicationPid()).arg(++number));
    if (!takeLock(*lock) || !QFileInfo(path).isDir())
        return nullptr;
    touch(path);
    return lock;
}

bool FolderCache::isHeld(const QString& path) const
{
    const QFileInfo info(path);
    const QStringList marks =
        info.dir().entryList({info.fileName() + openMark + u'*'}, QDir::Files | QDir::Hidden);
    return std::any_of(marks.begin(), marks.end(), [&info](const QString& mark) {
        QLockFile lock(info.dir().filePath(mark));
        // A dead process's mark goes with this.
        return !takeLock(lock);
    });
}

void FolderCache::remove(const QString& path) const
{
    // Gone at once for all who look, whatever ends the removal.
    const QString doomed = gatheringPlaceOf(path);
    const bool renamed = QDir().rename(path, doomed);
    QDir(renamed ? doomed : path).removeRecursively();
    QFile::remove(usedFile(path));
}

int FolderCache::shrinkTo(qint64 limit) const
{
    int removed = 0;
    // What broke off longer ago than a day is gone on with by nobody.
    constexpr int patienceDays = 1;
    const QDir folder(m_folder);
    const QDateTime old = QDateTime::currentDateTimeUtc().addDays(-patienceDays);
    for (const QFileInfo& info : folder.entryInfoList(
             {u'*' + gatheringMark}, QDir::Dirs | QDir::Hidden | QDir::NoSymLinks)) {
        if (limit > 0 && info.lastModified() > old)
            continue;
        QLockFile lock(info.filePath() + QStringLiteral(".lock"));
        if (takeLock(lock))
            QDir(info.filePath()).removeRecursively();
    }
    std::vector<Entry> all = entries();
    qint64 total = bytes();
    while (total > limit && !all.empty()) {
        const Entry oldest = all.back();
        all.pop_back();
        if (isHeld(oldest.path))
            continue;
        remove(oldest.path);
        total -= oldest.bytes;
        ++removed;
    }
    return removed;
}

} // namespace core
