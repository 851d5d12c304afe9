// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionFile.h"

#include "core/base/Guarded.h"
#include "core/base/files/StagedError.h"
#include "core/base/files/StagedFile.h"
#include "core/sessionfile/SessionCopy.h"
#include "core/sessionfile/SessionPlaces.h"
#include "core/sessionfile/records/SessionTables.h"
#include "core/sessionfile/records/SessionUse.h"

#include <QFileInfo>

#include <utility>

namespace core {

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
    if (!gone)
        goOnUnnamed(staged);
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
    // Somebody deleted the one before meanwhile.
    if (!gone && ownPlace && !QFileInfo::exists(m_path)) {
        m_waiting.clear();
        goOnUnnamed(**staged);
    }
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
    if (!isSessionInUse(staged.target()))
        removeSessionParts(staged.target());
    return tl::unexpected(takingBack(gone.error(), staged));
}

/// On the writer's thread. There is no other file that holds the session, and goOnIn() could not
/// give it its name.
void SessionFile::goOnUnnamed(StagedFile& staged)
{
    setPath(staged.path().isEmpty() ? staged.target() : staged.path());
    staged.release();
    openAgain();
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

/// On the writer's thread. What is written to a file without a name, or under one that the session
/// does not know, would be lost when it is closed.
Result<void> SessionFile::keepName()
{
    if (!m_tables || m_followed.isAt(m_path))
        return {};
    const QString before = m_path;
    const QString now = m_followed.path();
    const Result<void> kept = now.isEmpty() ? writeAnew() : followTo(now);
    if (!kept)
        return kept;
    {
        const std::lock_guard lock(m_mutex);
        const QString name = QFileInfo(before).fileName();
        const Clause what = !now.isEmpty()
            ? Clause::saying("another program renamed or moved '%1'", name)
            : before == m_path
            ? Clause::saying("another program deleted it; it was written anew")
            : Clause::saying("another program put another file in the place of '%1'", name);
        m_moved = Error{ErrorCode::SessionMoved, {m_path, what, before}};
    }
    if (m_troubleListener)
        m_troubleListener();
    return {};
}

/// On the writer's thread. The file has another name now.
Result<void> SessionFile::followTo(const QString& path)
{
    if (!m_tables->leaveName())
        return failure(ErrorCode::FileUnwritable, path,
            Clause::saying("another program renamed '%1' while it was open", m_path));
    m_whyShut = Error{ErrorCode::FileUnwritable, {path}};
    m_tables.reset();
    setPath(path);
    const Result<void> opened = reopen(path);
    if (!opened)
        m_whyShut = opened.error();
    return opened;
}

/// On the writer's thread. The file has no name any more: it stays open until a copy of it has one.
Result<void> SessionFile::writeAnew()
{
    const auto named = [this](Error error) {
        error.arguments.set(1,
            Clause::saying("another program deleted '%1' while it was open, and it cannot be "
                           "written anew: %2",
                m_path, error.arguments.value(1)));
        return error;
    };
    const QString target = freeSessionName(m_path);
    const Result<std::shared_ptr<StagedFile>> made =
        stageSessionCopy(target, false, true, parts(), {});
    if (!made)
        return tl::unexpected(named(made.error()));
    // From here on it is the only one.
    StagedFile staged = StagedFile::adopt((*made)->path(), target);
    (*made)->release();
    m_tables->leaveName();
    m_whyShut = Error{ErrorCode::FileUnwritable, {target}};
    m_tables.reset();
    m_waiting.clear();
    const Result<void> gone = goOnIn(staged);
    if (gone)
        return gone;
    goOnUnnamed(staged);
    return tl::unexpected(named(gone.error()));
}

/// On the writer's thread.
Result<void> SessionFile::reopen(const QString& path)
{
    // SQLite would make one that is not there.
    if (const Result<void> there = checkSessionToOpen(path, Access::ReadWrite); !there)
        return there;
    auto tables = std::make_unique<SessionTables>(path);
    if (const Result<SessionContents> read = tables->open(Access::ReadWrite); !read)
        return tl::unexpected(read.error());
    m_tables = std::move(tables);
    m_followed = FollowedFile(path);
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
    if (const QString now = m_followed.path(); !now.isEmpty() && !QFileInfo::exists(m_path))
        setPath(now);
    if (const Result<void> opened = guarded([this] { return reopen(m_path); }); !opened)
        m_whyShut = opened.error();
}

} // namespace core
