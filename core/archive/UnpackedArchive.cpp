// SPDX-License-Identifier: Apache-2.0
#include "core/archive/UnpackedArchive.h"

#include "core/archive/ArchiveReader.h"
#include "core/base/files/FolderCache.h"
#include "core/base/files/SystemFile.h"
#include "core/base/files/TakeLock.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include <map>
#include <mutex>

namespace core {

namespace {

/// Where all of it lies, and what this process has asked for.
struct Kept {
    std::mutex mutex;
    QString folder;
    std::map<QString, FolderCache::Hold> held;
};

Kept& kept()
{
    static Kept only;
    return only;
}

QString nameFor(const QString& path)
{
    const QFileInfo info(path);
    const QString facts = info.canonicalFilePath() + QChar(0) + QString::number(info.size())
        + QChar(0) + QString::number(info.lastModified().toMSecsSinceEpoch());
    return QString::fromLatin1(
        QCryptographicHash::hash(facts.toUtf8(), QCryptographicHash::Sha256).toHex().left(32));
}

/// Everything in a folder, and the folder itself.
QStringList pathsIn(const QString& folder)
{
    QStringList paths{folder};
    QDirIterator walk(folder, QDir::Files | QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot,
        QDirIterator::Subdirectories);
    while (walk.hasNext())
        paths += walk.next();
    return paths;
}

/// Unpacks where nobody looks, and renames when all of it is on the disk.
Result<void> gather(const QString& path, const QString& folder, const Progress& progress)
{
    const QString gathering = FolderCache::gatheringPlaceOf(folder);
    QLockFile lock(gathering + QStringLiteral(".lock"));
    const auto unwritable = [&] {
        return failure(ErrorCode::FileUnwritable, path,
            Clause::saying("the cache %1 cannot be written", QFileInfo(folder).path()));
    };
    // Another process may just unpack the same.
    constexpr int patienceMs = 100;
    while (!takeLock(lock, patienceMs)) {
        if (lock.error() != QLockFile::LockFailedError)
            return unwritable();
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
    }
    if (QDir(folder).exists())
        return {};
    QDir(gathering).removeRecursively();
    if (!QDir().mkpath(gathering))
        return failure(ErrorCode::FileUnwritable, path,
            Clause::saying("no folder %1 to unpack to", gathering));
    Result<void> unpacked = unpackArchive(path, gathering, progress);
    if (unpacked && QDir(gathering).isEmpty())
        unpacked = failure(ErrorCode::FolderEmpty, path);
    if (unpacked && syncAllToDisk(pathsIn(gathering)) != 0)
        unpacked = unwritable();
    if (unpacked && !QDir().rename(gathering, folder))
        unpacked = failure(ErrorCode::FileUnwritable, path, Clause::saying("cannot rename"));
    QDir(gathering).removeRecursively();
    // The folder is in place; one above it that cannot be synchronised is no error.
    syncToDisk(QFileInfo(folder).path());
    return unpacked;
}

} // namespace

QString archiveCacheFolder()
{
    const std::lock_guard lock(kept().mutex);
    return kept().folder.isEmpty()
        ? QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation)
            + QStringLiteral("/burin/archives")
        : kept().folder;
}

void setArchiveCacheFolder(const QString& folder)
{
    const std::lock_guard lock(kept().mutex);
    kept().folder = folder;
    kept().held.clear();
}

Result<QString> unpackedArchive(const QString& path, const Progress& progress, qint64 mostBytes)
{
    const FolderCache cache(archiveCacheFolder());
    if (const Result<void> prepared = cache.prepare(); !prepared)
        return tl::unexpected<Error>(prepared.error());
    const QString folder = cache.placeOf(nameFor(path));
    FolderCache::Hold hold = cache.hold(folder);
    while (!hold) {
        if (const Result<void> gathered = gather(path, folder, progress); !gathered)
            return tl::unexpected<Error>(gathered.error());
        hold = cache.hold(folder);
    }
    {
        const std::lock_guard lock(kept().mutex);
        kept().held[folder] = std::move(hold);
    }
    cache.shrinkTo(mostBytes);
    return folder;
}

} // namespace core
