// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionFile.h"

#include "core/session/SessionTables.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <utility>

namespace core {

SessionFile::SessionFile(const QString& path)
    : m_path(path)
    , m_tables(std::make_unique<SessionTables>(path))
{
}

SessionFile::~SessionFile()
{
    m_writer.run([this] { m_tables.reset(); });
}

Result<std::unique_ptr<SessionFile>> SessionFile::create(
    const QString& path, const SessionSource& source, bool replaceExisting)
{
    const QFileInfo info(path);
    if (info.exists() && !replaceExisting)
        return failure(ErrorCode::FileExists, path);
    if (info.isDir())
        return failure(ErrorCode::FileUnwritable, path, QStringLiteral("it is a folder"));
    if (!info.absoluteDir().exists())
        return failure(ErrorCode::FileUnwritable, path,
            QStringLiteral("there is no folder %1").arg(info.absolutePath()));
    for (const char* suffix : {"", "-wal", "-shm", "-journal"})
        QFile::remove(path + QLatin1String(suffix));
    QFile empty(path);
    if (!empty.open(QIODevice::WriteOnly | QIODevice::NewOnly,
            QFileDevice::ReadOwner | QFileDevice::WriteOwner))
        return failure(ErrorCode::FileUnwritable, path, empty.errorString());
    empty.close();

    std::unique_ptr<SessionFile> file(new SessionFile(path));
    Result<void> created;
    file->m_writer.run([&] { created = file->m_tables->create(source); });
    if (!created) {
        file.reset();
        QFile::remove(path);
        return tl::unexpected(created.error());
    }
    file->m_contents.source = source;
    return file;
}

Result<std::unique_ptr<SessionFile>> SessionFile::open(const QString& path, Access access)
{
    const QFileInfo info(path);
    if (!info.exists())
        return failure(ErrorCode::FileNotFound, path);
    if (info.isDir())
        return failure(ErrorCode::FileUnreadable, path, QStringLiteral("it is a folder"));
    if (!info.isReadable())
        return failure(ErrorCode::FileUnreadable, path, QStringLiteral("permission denied"));
    if (info.size() == 0)
        return failure(ErrorCode::FileTruncated, path, QStringLiteral("it is empty"));
    const bool readOnly = access == Access::ReadOnly;
    if (!readOnly && !(info.isWritable() && QFileInfo(info.absolutePath()).isWritable()))
        return failure(ErrorCode::FileUnwritable, path,
            QStringLiteral("a session is written while it is open; copy it to a folder of yours"));
    std::unique_ptr<SessionFile> file(new SessionFile(path));
    Result<SessionContents> contents;
    file->m_writer.run([&] { contents = file->m_tables->open(readOnly); });
    if (!contents)
        return tl::unexpected(contents.error());
    file->m_contents = *std::move(contents);
    return file;
}

bool SessionFile::isNamedAt(const QString& path)
{
    const QFileInfo info(path);
    if (!info.isFile())
        return false;
    if (info.suffix().compare(QLatin1String("burin"), Qt::CaseInsensitive) == 0)
        return true;
    QFile file(path);
    return file.open(QIODevice::ReadOnly) && file.read(15) == "SQLite format 3";
}

void SessionFile::addRow(const HistoryRow& row)
{
    m_writer.post([this, text = RowText::of(row)] { m_tables->addRow(text); });
}

void SessionFile::completeRow(RowId row, const QByteArray& stateHash, const BrickDelta& delta)
{
    m_writer.post([this, row, stateHash, delta] { m_tables->completeRow(row, stateHash, delta); });
}

void SessionFile::setPosition(RowId position)
{
    m_writer.post([this, position] { m_tables->setPosition(position); });
}

void SessionFile::setHiddenSegments(const std::vector<int>& labels)
{
    m_writer.post([this, labels] { m_tables->setHiddenSegments(labels); });
}

Result<BrickDelta> SessionFile::readDelta(RowId row)
{
    Result<BrickDelta> result;
    m_writer.run([&] { result = m_tables->readDelta(row); });
    return result;
}

Result<void> SessionFile::flush()
{
    Result<void> result;
    m_writer.run([&] { result = m_tables->written(); });
    return result;
}

} // namespace core
