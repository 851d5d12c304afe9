// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionFile.h"

#include "core/session/AuditReport.h"
#include "core/session/SessionTables.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace core {

SessionFile::SessionFile(const QString& path)
    : m_path(path)
    , m_tables(std::make_unique<SessionTables>(path))
{
}

SessionFile::~SessionFile()
{
    m_writer.run([this] {
        m_troubleListener = {};
        writeWaiting();
        m_tables.reset();
    });
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
    post({.carryOut = [text = RowText::of(row)](
                          SessionTables& tables) { return tables.addRow(text); }});
}

void SessionFile::completeRow(RowId row, const QByteArray& stateHash, const BrickDelta& delta)
{
    const auto shared = std::make_shared<const BrickDelta>(delta);
    post({.carryOut =
              [row, stateHash, shared](
                  SessionTables& tables) { return tables.completeRow(row, stateHash, *shared); },
        .row = row,
        .delta = shared});
}

void SessionFile::setPosition(RowId position)
{
    post({.carryOut = [position](SessionTables& tables) { return tables.setPosition(position); }});
}

void SessionFile::setHiddenSegments(const std::vector<int>& labels)
{
    post(
        {.carryOut = [labels](SessionTables& tables) { return tables.setHiddenSegments(labels); }});
}

void SessionFile::addKeyframe(const Keyframe& keyframe)
{
    post({.carryOut = [keyframe](SessionTables& tables) { return tables.addKeyframe(keyframe); }});
}

void SessionFile::fetchKeyframe(RowId row, std::function<void(const QByteArray& png)> take)
{
    m_writer.post([this, row, take = std::move(take)] { take(m_tables->readKeyframe(row)); });
}

void SessionFile::audit(std::function<void(const Result<AuditReport>&)> take)
{
    m_writer.post([this, take = std::move(take)] { take(auditReport(*m_tables, m_path)); });
}

void SessionFile::setDisplay(const QJsonObject& display)
{
    post({.carryOut = [display](SessionTables& tables) { return tables.setDisplay(display); }});
}

void SessionFile::post(Write write)
{
    m_writer.post([this, write = std::move(write)] {
        m_waiting.push_back(write);
        writeWaiting();
    });
}

void SessionFile::retry()
{
    m_writer.post([this] { writeWaiting(); });
}

void SessionFile::writeWaiting()
{
    std::optional<Error> trouble;
    while (!m_waiting.empty() && !trouble) {
        if (const Result<void> written = m_waiting.front().carryOut(*m_tables); written)
            m_waiting.pop_front();
        else
            trouble = written.error();
    }
    setTrouble(trouble);
}

void SessionFile::setTrouble(const std::optional<Error>& trouble)
{
    bool changed = false;
    {
        const std::lock_guard lock(m_mutex);
        changed = m_trouble.has_value() != trouble.has_value();
        m_trouble = trouble;
    }
    if (changed && m_troubleListener)
        m_troubleListener();
}

std::optional<Error> SessionFile::trouble() const
{
    const std::lock_guard lock(m_mutex);
    return m_trouble;
}

void SessionFile::setTroubleListener(std::function<void()> listener)
{
    m_troubleListener = std::move(listener);
}

Result<BrickDelta> SessionFile::readDelta(RowId row)
{
    Result<BrickDelta> result;
    m_writer.run([&] {
        const auto waits = std::find_if(m_waiting.begin(), m_waiting.end(),
            [row](const Write& write) { return write.delta && write.row == row; });
        result = waits == m_waiting.end() ? m_tables->readDelta(row) : *waits->delta;
    });
    return result;
}

Result<void> SessionFile::flush()
{
    m_writer.run([this] { writeWaiting(); });
    if (const std::optional<Error> why = trouble())
        return tl::unexpected(*why);
    return {};
}

} // namespace core
