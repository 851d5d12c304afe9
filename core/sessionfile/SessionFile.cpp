// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionFile.h"

#include "core/base/Guarded.h"
#include "core/base/files/StagedFile.h"
#include "core/sessionfile/AuditReport.h"
#include "core/sessionfile/SessionCopy.h"
#include "core/sessionfile/SessionPlaces.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/records/SessionTables.h"

#include <QFile>

#include <utility>

namespace core {

SessionFile::SessionFile(const QString& path)
    : m_path(path)
    , m_tables(std::make_unique<SessionTables>(path))
{
    m_closable.emplace([this](const Error& why) {
        m_writer.run([&] {
            writeWaiting();
            m_tables.reset();
            m_whyShut.reset();
            const std::lock_guard guard(m_mutex);
            m_whyNoFile = why;
        });
    });
}

SessionFile::~SessionFile()
{
    m_closable.reset();
    // What cannot be closed orderly is recovered when it is opened again.
    constexpr int tries = 3;
    for (int i = 0; i < tries; ++i) {
        if (guarded([this] { m_writer.run([this] { close(); }); }))
            return;
    }
}

/// On the writer's thread.
void SessionFile::close()
{
    m_troubleListener = {};
    writeWaiting();
    m_tables.reset();
}

Result<std::unique_ptr<SessionFile>> SessionFile::create(
    const QString& path, const SessionSource& source)
{
    if (const Result<void> made = makeEmptySession(path); !made)
        return tl::unexpected(made.error());
    auto begun = guarded([&] { return begin(path, source); });
    // With what SQLite left beside it; before, nothing was.
    if (!begun)
        removeSession(path);
    return begun;
}

Result<std::unique_ptr<SessionFile>> SessionFile::createIn(
    const StagedFile& staged, const SessionSource& source)
{
    QFile::setPermissions(staged.path(), QFileDevice::ReadOwner | QFileDevice::WriteOwner);
    return begin(staged.path(), source);
}

Result<std::unique_ptr<SessionFile>> SessionFile::begin(
    const QString& path, const SessionSource& source)
{
    std::unique_ptr<SessionFile> file(new SessionFile(path));
    Result<void> created;
    file->m_followed = FollowedFile(path);
    file->m_writer.run([&] { created = file->m_tables->create(source); });
    if (!created)
        return tl::unexpected(created.error());
    file->m_contents.source = source;
    return file;
}

std::unique_ptr<SessionFile> SessionFile::waiting(
    const QString& path, const SessionSource& source, const Error& why)
{
    std::unique_ptr<SessionFile> file(new SessionFile(path));
    file->m_contents.source = source;
    file->m_whyNoFile = why;
    file->m_writer.run([&file] { file->m_tables.reset(); });
    return file;
}

Result<std::unique_ptr<SessionFile>> SessionFile::open(const QString& path, Access access)
{
    if (const Result<void> there = checkSessionToOpen(path, access); !there)
        return tl::unexpected(there.error());
    std::unique_ptr<SessionFile> file(new SessionFile(path));
    Result<SessionContents> contents;
    // Before it is read, which may take a while.
    if (access == Access::ReadWrite)
        file->m_followed = FollowedFile(path);
    file->m_writer.run([&] { contents = file->m_tables->open(access); });
    if (!contents)
        return tl::unexpected(contents.error());
    file->m_contents = *std::move(contents);
    file->m_holdsImages = file->m_contents.holdsImages;
    file->m_isPrivateCopy = access == Access::PrivateCopy;
    return file;
}

bool SessionFile::isNamedAt(const QString& path)
{
    return isSessionNamedAt(path);
}

void SessionFile::addRow(const HistoryRow& row)
{
    // Its text may be long, with the voxels of a mask; the writer has the time for it.
    post({.carryOut = [shared = std::make_shared<const HistoryRow>(row)](
                          SessionTables& tables) { return tables.addRow(RowText::of(*shared)); },
        .isStep = true});
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
    post({.carryOut = [keyframe](SessionTables& tables) { return tables.addKeyframe(keyframe); },
        .row = keyframe.row,
        .picture = keyframe.png});
}

void SessionFile::fetchKeyframe(RowId row, std::function<void(const QByteArray& png)> take)
{
    m_writer.post(
        [this, row, take] {
            if (const QByteArray* waits = m_waiting.pictureOf(row))
                take(*waits);
            else
                take(m_tables ? m_tables->readKeyframe(row) : QByteArray());
        },
        [take](const Error&) { take({}); });
}

void SessionFile::audit(std::function<void(const Result<AuditReport>&)> take)
{
    m_writer.post(
        [this, take] {
            // What waits in memory is history, too, and no report is whole without it.
            writeWaiting();
            if (const std::optional<Error> why = trouble())
                take(tl::unexpected(*why));
            else if (m_tables)
                take(auditReport(*m_tables, m_path));
            else
                take(tl::unexpected(whyNoTables()));
        },
        [take](const Error& error) { take(tl::unexpected(error)); });
}

void SessionFile::setDisplay(const QJsonObject& display)
{
    post({.carryOut = [display](SessionTables& tables) { return tables.setDisplay(display); }});
}

void SessionFile::post(SessionWrite write)
{
    // Made here, so that there is nothing on the other side for which memory may be short.
    const auto written = std::make_shared<SessionWrites::List>();
    written->push_back(std::move(write));
    m_writer.post(
        [this, written] {
            m_waiting.append(*written);
            writeWaiting();
        },
        [this](const Error& error) { setTrouble(error); });
}

QString SessionFile::path() const
{
    const std::lock_guard lock(m_mutex);
    return m_path;
}

bool SessionFile::isPrivateCopy() const
{
    const std::lock_guard lock(m_mutex);
    return m_isPrivateCopy;
}

bool SessionFile::holdsImages() const
{
    const std::lock_guard lock(m_mutex);
    return m_holdsImages;
}

std::optional<Error> SessionFile::whyNoFile() const
{
    const std::lock_guard lock(m_mutex);
    return m_whyNoFile;
}

/// On the writer's thread.
Error SessionFile::whyNoTables() const
{
    return m_whyShut ? *m_whyShut : *whyNoFile();
}

void SessionFile::setPath(const QString& path)
{
    const std::lock_guard lock(m_mutex);
    m_path = path;
}

void SessionFile::retry()
{
    m_writer.post([this] { writeWaiting(); }, [this](const Error& error) { setTrouble(error); });
}

void SessionFile::writeWaiting()
{
    openAgain();
    if (Result<void> kept = guarded([this] { return keepName(); }); !kept) {
        if (kept.error().code != ErrorCode::FileUnwritable)
            kept.error() = {ErrorCode::FileUnwritable, {m_path, kept.error().arguments.value(0)}};
        return setTrouble(kept.error());
    }
    if (m_tables)
        setTrouble(m_waiting.carryOut(*m_tables, m_path));
    else
        setTrouble(m_whyShut || m_waiting.holdStep() ? std::optional(whyNoTables()) : std::nullopt);
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

std::optional<Error> SessionFile::takeMove()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_moved, std::nullopt);
}

void SessionFile::setTroubleListener(std::function<void()> listener)
{
    m_troubleListener = std::move(listener);
}

Result<BrickDelta> SessionFile::readDelta(RowId row)
{
    Result<BrickDelta> result;
    m_writer.run([&] {
        openAgain();
        if (const BrickDelta* waits = m_waiting.deltaOf(row))
            result = *waits;
        else if (m_tables)
            result = m_tables->readDelta(row);
        else
            result = tl::unexpected(whyNoTables());
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
