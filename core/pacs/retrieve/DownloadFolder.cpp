// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/retrieve/DownloadFolder.h"

#include "core/base/files/FolderCache.h"
#include "core/base/files/SystemFile.h"
#include "core/base/files/TakeLock.h"
#include "core/dicom/base/DicomFile.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

namespace core {

namespace {

/// A UID names its file itself where it is one; else a hash does.
QString fileName(const QString& uid)
{
    const bool plain = !uid.isEmpty() && uid.size() <= 64 && uid[0] != u'.'
        && std::all_of(
            uid.begin(), uid.end(), [](QChar c) { return (c >= u'0' && c <= u'9') || c == u'.'; });
    if (plain)
        return uid + QStringLiteral(".dcm");
    const QByteArray hash = QCryptographicHash::hash(uid.toUtf8(), QCryptographicHash::Sha256);
    return QString::fromLatin1(hash.toHex()) + QStringLiteral(".dcm");
}

constexpr const char* partPrefix = ".part-";
/// What can be believed of a gathering folder: of this start of the system everything, since it
/// reads what it was told to write; of an earlier one what was brought to the disk.
constexpr const char* noteName = ".download";
constexpr const char* onDisk = "on disk";

QByteArray thisStart()
{
    QFile file(QStringLiteral("/proc/sys/kernel/random/boot_id"));
    return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed() : QByteArray();
}

QByteArray readNote(const QDir& folder)
{
    QFile file(folder.filePath(QLatin1String(noteName)));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// @return what the system says against it, empty if nothing
QString writeNote(const QDir& folder, const QByteArray& note)
{
    QFile file(folder.filePath(QLatin1String(noteName)));
    if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) || file.write(note) != note.size())
        return file.errorString();
    return {};
}

void removeNote(const QDir& folder)
{
    QFile::remove(folder.filePath(QLatin1String(noteName)));
}

/// The folder with all its files. @return what the system says against it (errno); 0: it is done
int bringToDisk(const QDir& folder)
{
    QStringList paths;
    for (const QString& name : folder.entryList(QDir::Files))
        paths += folder.filePath(name);
    const int trouble = syncAllToDisk(paths);
    return trouble != 0 || syncToDisk(folder.path()) ? trouble : errno;
}

/// Has the system begin to write a file that is complete: less is left to wait for at the end.
void beginToWrite(const QByteArray& path)
{
    const int descriptor = ::open(path.constData(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    ::sync_file_range(descriptor, 0, 0, SYNC_FILE_RANGE_WRITE);
    ::close(descriptor);
}

/// What an earlier download left and nobody can believe.
void removeUnbelievable(const QDir& folder)
{
    const QByteArray note = readNote(folder);
    const bool believed = note == onDisk || (!note.isEmpty() && note == thisStart());
    for (const QString& name : folder.entryList(QDir::Files | QDir::Hidden)) {
        if (!believed || name.startsWith(QLatin1String(partPrefix)))
            QFile::remove(folder.filePath(name));
    }
}

tl::unexpected<Error> taken(const QString& target)
{
    return failure(ErrorCode::FileUnwritable, target,
        Clause::saying("there is something else, which stays as it is"));
}

} // namespace

Result<DownloadFolder> DownloadFolder::open(const QString& target)
{
    const QFileInfo info(QDir::cleanPath(QFileInfo(target).absoluteFilePath()));
    const bool isEmptyFolder = info.isDir() && QDir(info.filePath()).isEmpty();
    if ((info.exists() || info.isSymLink()) && !isEmptyFolder)
        return taken(target);
    const auto unwritable = [&target] {
        return failure(ErrorCode::FileUnwritable, target, systemReason(errno));
    };
    const QString gathering = FolderCache::gatheringPlaceOf(info.filePath());
    if (!QDir().mkpath(info.path()))
        return unwritable();
    // Before anything there is touched: it may be another's.
    auto lock = std::make_unique<QLockFile>(gathering + QStringLiteral(".lock"));
    if (!takeLock(*lock)) {
        if (lock->error() != QLockFile::LockFailedError)
            return unwritable();
        return failure(
            ErrorCode::FileUnwritable, target, Clause::saying("another download goes there"));
    }
    if (!QDir().mkpath(gathering))
        return unwritable();
    QFile::setPermissions(gathering, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    DownloadFolder folder;
    folder.m_target = info.filePath();
    folder.m_gathering = gathering;
    folder.m_lock = std::move(lock);
    removeUnbelievable(QDir(gathering));
    // An old note would be believed of what comes now.
    if (const QString trouble = writeNote(QDir(gathering), thisStart()); !trouble.isEmpty())
        return failure(ErrorCode::FileUnwritable, target, trouble);
    return folder;
}

DownloadFolder::~DownloadFolder()
{
    if (m_gathering.isEmpty())
        return;
    const QDir folder(m_gathering);
    if (folder.entryList(QDir::Files).isEmpty()) {
        removeNote(folder);
        QDir().rmdir(m_gathering);
    } else if (m_diskRefused || bringToDisk(folder) != 0) {
        removeNote(folder);
    } else {
        writeNote(folder, onDisk);
    }
}

bool DownloadFolder::isWhole(const QString& target, const QStringList& sopInstanceUids)
{
    const QDir folder(target);
    return !sopInstanceUids.isEmpty() && folder.exists()
        && std::all_of(sopInstanceUids.begin(), sopInstanceUids.end(), [&](const QString& uid) {
               return checkObject(folder.filePath(fileName(uid)), uid).has_value();
           });
}

void DownloadFolder::removeLockLeftOver(const QString& target)
{
    const QString path =
        FolderCache::gatheringPlaceOf(QDir::cleanPath(QFileInfo(target).absoluteFilePath()))
        + QStringLiteral(".lock");
    if (!QFileInfo::exists(path))
        return;
    QLockFile lock(path);
    static_cast<void>(takeLock(lock)); // its destructor removes the file
}

QString DownloadFolder::pathOf(const QString& sopInstanceUid) const
{
    return QDir(m_gathering).filePath(fileName(sopInstanceUid));
}

QString DownloadFolder::partPathOf(const QString& sopInstanceUid) const
{
    return QDir(m_gathering).filePath(QLatin1String(partPrefix) + fileName(sopInstanceUid));
}

bool DownloadFolder::holds(const QString& sopInstanceUid) const
{
    const QString path = pathOf(sopInstanceUid);
    if (!QFileInfo::exists(path))
        return false;
    if (checkObject(path, sopInstanceUid))
        return true;
    QFile::remove(path);
    return false;
}

Result<void> DownloadFolder::finish()
{
    if (const int trouble = bringToDisk(QDir(m_gathering))) {
        // The system tells of it once, and then takes for written what was not.
        m_diskRefused = true;
        return failure(ErrorCode::FileUnwritable, m_target, systemReason(trouble));
    }
    removeNote(QDir(m_gathering));
    const QByteArray from = QFile::encodeName(m_gathering);
    const QByteArray to = QFile::encodeName(m_target);
    // Replaces an empty folder, nothing else.
    if (std::rename(from.constData(), to.constData()) != 0) {
        if (errno == EEXIST || errno == ENOTEMPTY || errno == ENOTDIR)
            return taken(m_target);
        return failure(ErrorCode::FileUnwritable, m_target, systemReason(errno));
    }
    m_gathering.clear();
    // The folder is in place; one above it that cannot be synchronised is no error.
    syncToDisk(QFileInfo(m_target).path());
    return {};
}

Result<void> DownloadFolder::accept(const QString& partPath, const QString& sopInstanceUid) const
{
    const QByteArray from = QFile::encodeName(partPath);
    const QByteArray to = QFile::encodeName(pathOf(sopInstanceUid));
    beginToWrite(from);
    if (std::rename(from.constData(), to.constData()) != 0)
        return failure(ErrorCode::FileUnwritable, m_target, systemReason(errno));
    return {};
}

Result<QString> soundObject(const QString& path)
{
    const Result<DicomFile> file = DicomFile::openWithPixels(path);
    if (!file)
        return tl::unexpected<Error>(file.error());
    if (file->pixelsCut()) {
        return failure(
            ErrorCode::FileTruncated, path, Clause::saying("its pixel data are incomplete"));
    }
    DcmDataset set;
    if (const Result<void> read = file->readInto(set); !read)
        return tl::unexpected<Error>(read.error());
    OFString uid;
    set.findAndGetOFString(DCM_SOPInstanceUID, uid);
    return QString::fromLatin1(uid.c_str());
}

Result<void> checkObject(const QString& path, const QString& sopInstanceUid)
{
    const Result<QString> uid = soundObject(path);
    if (!uid)
        return tl::unexpected<Error>(uid.error());
    if (*uid != sopInstanceUid) {
        return failure(
            ErrorCode::FileUnreadable, path, Clause::saying("it is another object than was asked"));
    }
    return {};
}

} // namespace core
