// SPDX-License-Identifier: Apache-2.0
#include "core/archive/ArchiveReader.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSet>
#include <QStorageInfo>

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <memory>

namespace core {

namespace {

constexpr int mostFiles = 500000;
constexpr qint64 alwaysAllowed = qint64(1) << 30;
constexpr qint64 greatestRatio = 100;
constexpr qint64 leftOnDisk = qint64(1) << 30;

struct Freed {
    void operator()(archive* reader) const { archive_read_free(reader); }
};
using Reader = std::unique_ptr<archive, Freed>;

QString reasonOf(archive* reader)
{
    const char* text = archive_error_string(reader);
    return QString::fromLocal8Bit(text != nullptr ? text : "damaged");
}

/// Names in archives may be UTF-8, say so, or be bytes of whatever page the writer used.
QString nameOf(archive_entry* entry)
{
    if (const char* utf8 = archive_entry_pathname_utf8(entry))
        return QString::fromUtf8(utf8);
    const char* bytes = archive_entry_pathname(entry);
    return QString::fromLatin1(bytes != nullptr ? bytes : "");
}

/// Below the folder, whatever the archive says; empty for nothing.
QString placeOf(const QString& name)
{
    QStringList parts;
    const QString slashes = QString(name).replace(QLatin1Char('\\'), QLatin1Char('/'));
    for (QString part : slashes.split(QLatin1Char('/'), Qt::SkipEmptyParts)) {
        part.remove(QChar(0));
        if (part == QLatin1String(".") || part == QLatin1String("..") || part.isEmpty())
            continue;
        while (part.toUtf8().size() > 200)
            part.chop(1);
        parts += part;
    }
    constexpr qsizetype deepest = 32;
    return parts.size() > deepest ? QString() : parts.join(QLatin1Char('/'));
}

class Unpacking {
public:
    Unpacking(const QString& path, const QString& folder, const Progress& progress)
        : m_path(path)
        , m_folder(folder)
        , m_progress(progress)
        , m_size(QFileInfo(path).size())
        , m_room(std::max(alwaysAllowed, greatestRatio * m_size))
        , m_onDisk(QStorageInfo(folder).bytesAvailable() - leftOnDisk)
    {
    }

    Result<void> run()
    {
        const Reader reader(archive_read_new());
        archive_read_support_format_zip(reader.get());
        archive_read_support_format_7zip(reader.get());
        archive_read_support_format_tar(reader.get());
        archive_read_support_filter_gzip(reader.get());
        archive_read_support_filter_bzip2(reader.get());
        archive_read_support_filter_xz(reader.get());
        archive_read_support_filter_zstd(reader.get());
        constexpr std::size_t block = std::size_t(1) << 20;
        if (archive_read_open_filename(reader.get(), QFile::encodeName(m_path).constData(), block)
            != ARCHIVE_OK)
            return unreadable(reader.get());
        int files = 0;
        archive_entry* entry = nullptr;
        for (;;) {
            const int next = archive_read_next_header(reader.get(), &entry);
            if (next == ARCHIVE_EOF)
                return {};
            if (next < ARCHIVE_WARN)
                return unreadable(reader.get());
            if (m_progress.cancelled())
                return failure(ErrorCode::Cancelled);
            if (++files > mostFiles)
                return failure(ErrorCode::UnsupportedFormat, m_path,
                    Clause::saying("it holds more than %1 files", mostFiles));
            if (archive_entry_filetype(entry) != AE_IFREG)
                continue;
            if (archive_entry_is_data_encrypted(entry) != 0)
                return failure(ErrorCode::FileUnreadable, m_path,
                    Clause::saying("it is protected by a password; unpack it first"));
            const QString place = freePlace(placeOf(nameOf(entry)));
            if (place.isEmpty())
                continue;
            if (const Result<void> written = write(reader.get(), place); !written)
                return written;
        }
    }

private:
    tl::unexpected<Error> unreadable(archive* reader) const
    {
        return failure(ErrorCode::FileUnreadable, m_path,
            Clause::saying("it is damaged or cut short (%1)", reasonOf(reader)));
    }

    /// Several files may have one name, or have names that become one.
    QString freePlace(const QString& place)
    {
        if (place.isEmpty())
            return {};
        QString free = place;
        for (int number = 2; m_taken.contains(free.toCaseFolded()); ++number)
            free = QStringLiteral("%1.%2").arg(place).arg(number);
        m_taken.insert(free.toCaseFolded());
        return free;
    }

    Result<void> write(archive* reader, const QString& place)
    {
        const QString target = m_folder + QLatin1Char('/') + place;
        QFile file(target);
        // A file where the archive has a folder elsewhere: what cannot be laid down is left out.
        if (!QDir().mkpath(QFileInfo(target).path()) || !file.open(QIODevice::WriteOnly))
            return failure(ErrorCode::FileUnwritable, m_path, file.errorString());
        for (;;) {
            const void* bytes = nullptr;
            std::size_t size = 0;
            la_int64_t at = 0;
            const int next = archive_read_data_block(reader, &bytes, &size, &at);
            if (next == ARCHIVE_EOF)
                break;
            if (next < ARCHIVE_WARN)
                return unreadable(reader);
            // Tar files may have holes, of any length.
            m_written += qint64(size) + std::max<qint64>(0, at - file.pos());
            if (m_written > m_room)
                return failure(ErrorCode::UnsupportedFormat, m_path,
                    Clause::saying("it unpacks to more than %1 times its size", greatestRatio));
            if (m_written > m_onDisk)
                return failure(ErrorCode::FileUnwritable, m_path,
                    Clause::saying("the disk has no room for what it unpacks to"));
            if (m_progress.cancelled())
                return failure(ErrorCode::Cancelled);
            if (at != file.pos() && !file.seek(at))
                return failure(ErrorCode::FileUnwritable, m_path, file.errorString());
            if (file.write(static_cast<const char*>(bytes), qint64(size)) != qint64(size))
                return failure(ErrorCode::FileUnwritable, m_path, file.errorString());
            const qint64 read = archive_filter_bytes(reader, -1);
            m_progress.report(ProgressStep::Unpacking, int(read >> 10), int(m_size >> 10) + 1);
        }
        file.close();
        if (file.error() != QFileDevice::NoError)
            return failure(ErrorCode::FileUnwritable, m_path, file.errorString());
        return {};
    }

    QString m_path;
    QString m_folder;
    const Progress& m_progress;
    qint64 m_size;
    qint64 m_room;
    qint64 m_onDisk;
    qint64 m_written = 0;
    QSet<QString> m_taken;
};

} // namespace

bool isArchive(const QString& path)
{
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly))
        return false;
    const QByteArray first = file.read(8);
    if (first.startsWith("PK\x03\x04") || first.startsWith("PK\x05\x06")
        || first.startsWith("7z\xbc\xaf\x27\x1c"))
        return true;
    const QString name = QFileInfo(path).fileName().toLower();
    constexpr const char* endings[] = {
        ".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tbz2", ".tar.xz", ".txz", ".tar.zst"};
    return std::any_of(std::begin(endings), std::end(endings),
        [&name](const char* ending) { return name.endsWith(QLatin1String(ending)); });
}

Result<void> unpackArchive(const QString& path, const QString& folder, const Progress& progress)
{
    return Unpacking(path, folder, progress).run();
}

} // namespace core
