// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionFile.h"

#include "core/base/Guarded.h"
#include "core/base/files/StagedError.h"
#include "core/base/files/StagedFile.h"
#include "core/sessionfile/SessionCopy.h"
#include "core/sessionfile/SessionPlaces.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/records/SessionTables.h"

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
    if (const Result<void> fits = checkSessionPlace(target, true); !fits)
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
    const bool ownPlace =
        m_tables && m_followed.isValid() && QFileInfo::exists(target) && m_followed.isAt(target);
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
    Error error = takingBack(gone.error(), staged);
    // The new one had to stay in the place of the session's own.
    if (m_whyShut && staged.path().isEmpty() && staged.target() == m_path)
        m_followed = FollowedFile(m_path);
    return tl::unexpected(std::move(error));
}

/// On the writer's thread. There is no other file that holds the session, and goOnIn() could not
/// give it its name.
void SessionFile::goOnUnnamed(StagedFile& staged)
{
    setPath(staged.path().isEmpty() ? staged.target() : staged.path());
    m_followed = FollowedFile(m_path);
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
    const QString now = m_followed.path();
    return !now.isEmpty() && canFollowTo(now) ? followTo(now) : writeAnew();
}

/// On the writer's thread. SQLite would take for the session's own what lies beside the new name.
bool SessionFile::canFollowTo(const QString& path) const
{
    const QString wal = path + QLatin1String("-wal");
    const QString stray = strayPartOf(path);
    return checkSessionToOpen(path, Access::ReadWrite)
        && (stray.isEmpty() || (QFileInfo::exists(wal) && m_tables->isOwnWal(wal)));
}

/// On the writer's thread. The file has another name now.
Result<void> SessionFile::followTo(const QString& path)
{
    const QString before = m_path;
    const Clause what =
        Clause::saying("another program renamed or moved '%1'", QFileInfo(before).fileName());
    if (!m_tables->gather())
        return failure(
            ErrorCode::FileUnwritable, path, Clause::saying("%1; %2", what, m_tables->reason()));
    Error shut{ErrorCode::FileUnwritable, {path}};
    m_tables->leaveName(path);
    m_whyShut = std::move(shut);
    m_tables.reset();
    setPath(path);
    noteMove(what, before);
    openAgain();
    return m_whyShut ? tl::unexpected(*m_whyShut) : Result<void>();
}

/// On the writer's thread. The file has no name any more, or one that is of no use: it stays open
/// until a copy of it has one.
Result<void> SessionFile::writeAnew()
{
    const QString before = m_path;
    const auto named = [&before](const Error& error) {
        return failure(ErrorCode::FileUnwritable, before,
            Clause::saying("another program deleted or replaced it while it was open, and it "
                           "cannot be written anew: %1",
                error.arguments.value(error.code == ErrorCode::FileUnwritable ? 1 : 0)));
    };
    const Result<std::shared_ptr<StagedFile>> made =
        stageSessionCopy(freeSessionName(before), false, true, parts(), {});
    if (!made)
        return named(made.error());
    // The connection reads on without a name of its own; beside the new file it would be damage.
    m_tables->leaveName({});
    constexpr int tries = 5;
    for (int i = 0; i < tries; ++i) {
        const QString target = freeSessionName(before);
        const Clause what = target == before
            ? Clause::saying("another program deleted it; it was written anew")
            : Clause::saying("another program took '%1' away; it was written anew",
                QFileInfo(before).fileName());
        Error shut{ErrorCode::FileUnwritable, {target}};
        FollowedFile followed((*made)->path());
        StagedFile copy = StagedFile::adopt((*made)->path(), target, false);
        if (const Result<void> placed = copy.commit(); !placed) {
            // Somebody was faster.
            if (placed.error().code == ErrorCode::FileExists)
                continue;
            return named(placed.error());
        }
        (*made)->release();
        m_followed = std::move(followed);
        m_whyShut = std::move(shut);
        m_tables.reset();
        m_waiting.clear();
        setPath(target);
        noteMove(what, before);
        openAgain();
        return m_whyShut ? tl::unexpected(*m_whyShut) : Result<void>();
    }
    return named({ErrorCode::FileUnwritable, {before, Clause::saying("its name is taken")}});
}

void SessionFile::noteMove(const Clause& what, const QString& before)
{
    {
        const std::lock_guard lock(m_mutex);
        m_moved = Error{ErrorCode::SessionMoved, {m_path, what, before}};
    }
    if (m_troubleListener)
        m_troubleListener();
}

/// On the writer's thread.
Result<void> SessionFile::reopen(const QString& path)
{
    // SQLite would make one that is not there.
    if (const Result<void> there = checkSessionToOpen(path, Access::ReadWrite); !there)
        return there;
    auto tables = std::make_unique<SessionTables>(path);
    FollowedFile followed(path);
    if (const Result<SessionContents> read = tables->open(Access::ReadWrite); !read)
        return tl::unexpected(read.error());
    m_tables = std::move(tables);
    m_followed = std::move(followed);
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
    const Result<void> opened = guarded([this]() -> Result<void> {
        const QString now = m_followed.isAt(m_path) ? m_path : m_followed.path();
        if (now.isEmpty())
            return failure(ErrorCode::FileUnwritable, m_path,
                Clause::saying("another program deleted or replaced it"));
        if (now != m_path) {
            const QString before = m_path;
            setPath(now);
            noteMove(Clause::saying(
                         "another program renamed or moved '%1'", QFileInfo(before).fileName()),
                before);
        }
        return reopen(now);
    });
    if (!opened)
        m_whyShut = opened.error();
}

} // namespace core
