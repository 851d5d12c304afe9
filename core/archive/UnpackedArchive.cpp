// SPDX-License-Identifier: Apache-2.0
#include "core/archive/UnpackedArchive.h"

#include "core/archive/ArchiveReader.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QLockFile>
#include <QStandardPaths>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace core {

namespace {

/// Locks of what this process uses, by folder; and where all of it lies.
struct Cache {
    std::mutex mutex;
    QString folder;
    std::map<QString, std::unique_ptr<QLockFile>> used;
};

Cache& cache()
{
    static Cache only;
    return only;
}

std::unique_ptr<QLockFile> lockOf(const QString& folder)
{
    auto lock = std::make_unique<QLockFile>(folder + QStringLiteral(".lock"));
    // Whoever holds it may do so for days; one whose process is gone is found out by its number.
    lock->setStaleLockTime(0);
    return lock;
}

QString nameFor(const QString& path)
{
    const QFileInfo info(path);
    const QString facts = info.canonicalFilePath() + QChar(0) + QString::number(info.size())
        + QChar(0) + QString::number(info.lastModified().toMSecsSinceEpoch());
    return QString::fromLatin1(
        QCryptographicHash::hash(facts.toUtf8(), QCryptographicHash::Sha256).toHex().left(32));
}

qint64 bytesIn(const QString& folder)
{
    qint64 bytes = 0;
    QDirIterator files(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        files.next();
        bytes += files.fileInfo().size();
    }
    return bytes;
}

/// The time of this file tells when its folder was used last.
QString markOf(const QString& folder)
{
    return folder + QStringLiteral(".used");
}

void mark(const QString& folder)
{
    QFile file(markOf(folder));
    if (file.open(QIODevice::WriteOnly))
        file.setFileTime(QDateTime::currentDateTime(), QFileDevice::FileModificationTime);
}

void removeLeastUsed(const QString& root, qint64 mostBytes)
{
    struct Kept {
        QString folder;
        QDateTime used;
        qint64 bytes = 0;
    };
    std::vector<Kept> kept;
    qint64 all = 0;
    for (const QString& name : QDir(root).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        const QString folder = root + QLatin1Char('/') + name;
        kept.push_back({folder, QFileInfo(markOf(folder)).lastModified(), bytesIn(folder)});
        all += kept.back().bytes;
    }
    std::sort(
        kept.begin(), kept.end(), [](const Kept& a, const Kept& b) { return a.used < b.used; });
    const QDateTime yesterday = QDateTime::currentDateTime().addDays(-1);
    for (const Kept& each : kept) {
        if (all <= mostBytes)
            return;
        // What another process is just writing.
        if (each.folder.contains(QLatin1String(".part"))
            && QFileInfo(each.folder).lastModified() > yesterday)
            continue;
        const std::unique_ptr<QLockFile> lock = lockOf(each.folder);
        if (!lock->tryLock(0))
            continue;
        if (QDir(each.folder).removeRecursively())
            all -= each.bytes;
        QFile::remove(markOf(each.folder));
    }
}

} // namespace

QString archiveCacheFolder()
{
    const std::lock_guard lock(cache().mutex);
    return cache().folder.isEmpty()
        ? QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation)
            + QStringLiteral("/burin/archives")
        : cache().folder;
}

void setArchiveCacheFolder(const QString& folder)
{
    const std::lock_guard lock(cache().mutex);
    cache().folder = folder;
    cache().used.clear();
}

Result<QString> unpackedArchive(const QString& path, const Progress& progress, qint64 mostBytes)
{
    const QString root = archiveCacheFolder();
    const QString folder = root + QLatin1Char('/') + nameFor(path);
    constexpr auto ownOnly = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner;
    if (!QDir().mkpath(root) || !QFile::setPermissions(root, ownOnly))
        return failure(
            ErrorCode::FileUnwritable, path, QStringLiteral("no folder %1 to unpack to").arg(root));
    const std::lock_guard once(cache().mutex);
    if (!cache().used.contains(folder)) {
        std::unique_ptr<QLockFile> lock = lockOf(folder);
        // Another process may be about to unpack it, or may just have it open: either way it is not
        // removed meanwhile.
        constexpr int patienceMs = 200;
        if (lock->tryLock(patienceMs))
            cache().used.emplace(folder, std::move(lock));
    }
    if (!QDir(folder).exists()) {
        const QString gathering =
            folder + QStringLiteral(".part%1").arg(QCoreApplication::applicationPid());
        QDir(gathering).removeRecursively();
        if (!QDir().mkpath(gathering) || !QFile::setPermissions(gathering, ownOnly))
            return failure(ErrorCode::FileUnwritable, path,
                QStringLiteral("no folder %1 to unpack to").arg(gathering));
        Result<void> unpacked = unpackArchive(path, gathering, progress);
        if (unpacked && !QDir().rename(gathering, folder) && !QDir(folder).exists())
            unpacked = failure(ErrorCode::FileUnwritable, path, QStringLiteral("cannot rename"));
        QDir(gathering).removeRecursively();
        if (!unpacked)
            return tl::unexpected<Error>(unpacked.error());
    }
    mark(folder);
    removeLeastUsed(root, mostBytes);
    return folder;
}

} // namespace core
