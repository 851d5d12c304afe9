// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionFile.h"

#include "core/base/Guarded.h"
#include "core/base/files/StagedError.h"
#include "core/base/files/StagedFile.h"
#include "core/sessionfile/AuditReport.h"
#include "core/sessionfile/SessionCopy.h"
#include "core/sessionfile/SessionPlaces.h"
#include "core/sessionfile/records/SessionTables.h"
#include "core/sessionfile/records/SessionUse.h"

#include <QFile>
#include <QFileInfo>

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
            if (m_tables)
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

void SessionFile::saveAs(const QString& target, bool replaceExisting,
    std::function<void(const Result<void>&)> done, SavedImages images)
{
    m_writer.post(
        [this, target, replaceExisting, images = std::move(images), done]() mutable {
            writeWaiting();
            const Result<void> moved =
                guarded([&] { return moveTo(target, replaceExisting, images); });
            images = {}; // what was staged and is not used is gone before anybody is told
            writeWaiting();
            done(moved);
        },
        [done](const Error& error) { done(tl::unexpected(error)); });
}

Result<void> SessionFile::rename(const QString& target)
{
    Result<void> renamed;
    m_writer.run([&] {
        writeWaiting();
        const std::optional<Error> why = trouble();
        renamed = why ? tl::unexpected(*why) : renameTo(target);
    });
    return renamed;
}

/// On the writer's thread.
Result<void> SessionFile::renameTo(const QString& target)
{
    if (const Result<void> fits = checkReplacedSession(target); !fits)
        return fits;
    if (const Result<void> closed = closeAsOneFile(); !closed)
        return closed;
    StagedFile staged = StagedFile::adopt(m_path, target);
    const Result<void> gone = goOnIn(staged);
    if (gone)
        return gone;
    setPath(staged.path().isEmpty() ? target : staged.path());
    staged.release();
    openAgain();
    return gone;
}

void SessionFile::copyTo(const QString& path, std::function<void(const Result<void>&)> done)
{
    m_writer.post(
        [this, path, done] {
            writeWaiting();
            const Result<void> copied = guarded([&]() -> Result<void> {
                if (m_whyShut)
                    return tl::unexpected(*m_whyShut);
                return copySessionInto(path, parts(), {.kept = false});
            });
            if (!copied)
                removeSession(path);
            done(copied);
        },
        [done](const Error& error) { done(tl::unexpected(error)); });
}

SessionParts SessionFile::parts() const
{
    return {.tables = m_tables.get(), .source = m_contents.source, .waiting = m_waiting};
}

/// On the writer's thread.
Result<void> SessionFile::moveTo(
    const QString& target, bool replaceExisting, const SavedImages& images)
{
    if (m_whyShut)
        return failure(ErrorCode::FileUnwritable, target,
            Clause::saying("the steps so far are in '%1', which does not open: %2", path(),
                m_whyShut->arguments.value(1)));
    const bool ownPlace = m_tables && !m_isPrivateCopy && QFileInfo::exists(target)
        && QFileInfo(target).canonicalFilePath() == QFileInfo(m_path).canonicalFilePath();
    const Result<std::shared_ptr<StagedFile>> staged =
        stageSessionCopy(target, replaceExisting, ownPlace, parts(), images);
    if (!staged)
        return tl::unexpected(staged.error());
    if (ownPlace) {
        if (const Result<void> closed = closeAsOneFile(); !closed)
            return closed;
    }
    const Result<void> gone = goOnIn(**staged);
    // What waits is in the copy, too, which may have had to stay in the file's place.
    if (gone || (ownPlace && (*staged)->path().isEmpty()))
        m_waiting.clear();
    if (!gone)
        return gone;
    {
        const std::lock_guard lock(m_mutex);
        m_isPrivateCopy = false;
        m_holdsImages = m_tables->holdsImages();
    }
    setTrouble({});
    return {};
}

/// On the writer's thread. Gives a file that holds the session its name and opens it there. If one
/// of these fails, what had the name before has it again.
Result<void> SessionFile::goOnIn(StagedFile& staged)
{
    const Result<void> gone = guarded([&]() -> Result<void> {
        const Result<void> placed = staged.commit();
        return placed ? reopen(staged.target()) : placed;
    });
    if (gone)
        setPath(staged.target());
    if (gone || !staged.isCommitted())
        return gone;
    // SQLite made them for the new file: the old one had none.
    removeSessionParts(staged.target());
    return tl::unexpected(takingBack(gone.error(), staged));
}

/// On the writer's thread. Only for as long as the file gets another name or is replaced: nothing
/// of it may lie beside it then.
Result<void> SessionFile::closeAsOneFile()
{
    if (!m_tables)
        return tl::unexpected(whyNoTables());
    m_whyShut = Error{ErrorCode::FileUnwritable, {m_path}};
    m_tables.reset();
    if (!isSessionUnfinished(m_path))
        return {};
    openAgain();
    return failure(
        ErrorCode::FileUnwritable, m_path, Clause::saying("it could not be closed as one file"));
}

/// On the writer's thread.
Result<void> SessionFile::reopen(const QString& path)
{
    auto tables = std::make_unique<SessionTables>(path);
    if (const Result<SessionContents> read = tables->open(Access::ReadWrite); !read)
        return tl::unexpected(read.error());
    m_tables = std::move(tables);
    m_whyShut.reset();
    const std::lock_guard lock(m_mutex);
    m_whyNoFile.reset();
    return {};
}

/// On the writer's thread. Opens the file that was closed to be replaced and did not open since;
/// what is done meanwhile waits in memory.
void SessionFile::openAgain()
{
    if (!m_whyShut)
        return;
    if (const Result<void> opened = guarded([this] { return reopen(m_path); }); !opened)
        m_whyShut = opened.error();
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
