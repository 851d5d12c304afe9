// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/DownloadFolder.h"

#include "core/dicom/DicomFile.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fcntl.h>

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

/// Leaves of a download that ended in the middle of a file.
void removeHalves(const QDir& folder)
{
    for (const QString& name :
        folder.entryList({QStringLiteral(".burin-*")}, QDir::Files | QDir::Hidden))
        QFile::remove(folder.filePath(name));
}

tl::unexpected<Error> taken(const QString& target)
{
    return failure(ErrorCode::FileUnwritable, target,
        QStringLiteral("there is something else, which stays as it is"));
}

} // namespace

Result<DownloadFolder> DownloadFolder::open(const QString& target)
{
    const QFileInfo info(QDir::cleanPath(QFileInfo(target).absoluteFilePath()));
    const bool isEmptyFolder = info.isDir() && QDir(info.filePath()).isEmpty();
    if ((info.exists() || info.isSymLink()) && !isEmptyFolder)
        return taken(target);
    DownloadFolder folder;
    folder.m_target = info.filePath();
    const QDir parent = info.dir();
    folder.m_gathering = parent.filePath(QStringLiteral(".%1.burin-download").arg(info.fileName()));
    if (!parent.mkpath(folder.m_gathering))
        return failure(ErrorCode::FileUnwritable, target, QString::fromLocal8Bit(strerror(errno)));
    QFile::setPermissions(
        folder.m_gathering, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    folder.m_lock = std::make_unique<QLockFile>(folder.m_gathering + QStringLiteral(".lock"));
    folder.m_lock->setStaleLockTime(0);
    if (!folder.m_lock->tryLock()) {
        return failure(
            ErrorCode::FileUnwritable, target, QStringLiteral("another download goes there"));
    }
    removeHalves(QDir(folder.m_gathering));
    return folder;
}

DownloadFolder::~DownloadFolder()
{
    if (!m_gathering.isEmpty())
        QDir().rmdir(m_gathering);
}

bool DownloadFolder::isWhole(const QString& target, const QStringList& sopInstanceUids)
{
    const QDir folder(target);
    return !sopInstanceUids.isEmpty() && folder.exists()
        && std::all_of(sopInstanceUids.begin(), sopInstanceUids.end(), [&](const QString& uid) {
               return checkObject(folder.filePath(fileName(uid)), uid).has_value();
           });
}

QString DownloadFolder::pathOf(const QString& sopInstanceUid) const
{
    return QDir(m_gathering).filePath(fileName(sopInstanceUid));
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
    const QByteArray from = QFile::encodeName(m_gathering);
    const QByteArray to = QFile::encodeName(m_target);
    // Replaces an empty folder, nothing else.
    if (std::rename(from.constData(), to.constData()) != 0) {
        if (errno == EEXIST || errno == ENOTEMPTY || errno == ENOTDIR)
            return taken(m_target);
        return failure(
            ErrorCode::FileUnwritable, m_target, QString::fromLocal8Bit(strerror(errno)));
    }
    return {};
}

Result<void> checkObject(const QString& path, const QString& sopInstanceUid)
{
    const Result<DicomFile> file = DicomFile::openWithPixels(path);
    if (!file)
        return tl::unexpected<Error>(file.error());
    if (file->pixelsCut()) {
        return failure(
            ErrorCode::FileTruncated, path, QStringLiteral("its pixel data are incomplete"));
    }
    DcmDataset set;
    if (Result<void> read = file->readInto(set); !read)
        return read;
    OFString uid;
    set.findAndGetOFString(DCM_SOPInstanceUID, uid);
    if (QString::fromLatin1(uid.c_str()) != sopInstanceUid) {
        return failure(
            ErrorCode::FileUnreadable, path, QStringLiteral("it is another object than was asked"));
    }
    return {};
}

} // namespace core
