// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionFile.h"

#include "core/base/Guarded.h"
#include "core/base/files/ReadableFile.h"
#include "core/base/files/StagedFile.h"
#include "core/sessionfile/AuditReport.h"
#include "core/sessionfile/records/CloseSessionFiles.h"
#include "core/sessionfile/records/SessionTables.h"
#include "core/sessionfile/records/SessionUse.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <map>
#include <utility>

namespace core {

namespace {

const QString inUse = QStringLiteral("it is open in another window");

struct OpenFiles {
    std::mutex mutex;
    std::map<const SessionFile*, std::function<void(const Error&)>> closing; ///< under the mutex
};

/// Never destroyed: sessions may outlive other globals.
OpenFiles& openFiles()
{
    static auto* all = new OpenFiles;
    return *all;
}

} // namespace

void closeSessionFiles(const Error& why)
{
    const std::lock_guard lock(openFiles().mutex);
    for (const auto& [file, close] : openFiles().closing)
        close(why);
}

SessionFile::SessionFile(const QString& path)
    : m_path(path)
    , m_tables(std::make_unique<SessionTables>(path))
{
    const std::lock_guard lock(openFiles().mutex);
    openFiles().closing[this] = [this](const Error& why) {
        m_writer.run([&] {
            writeWaiting();
            m_tables.reset();
            const std::lock_guard guard(m_mutex);
            m_whyNoFile = why;
        });
    };
}

SessionFile::~SessionFile()
{
    {
        const std::lock_guard lock(openFiles().mutex);
        openFiles().closing.erase(this);
    }
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
    if (const Result<void> free = checkFileTarget(path, false); !free)
        return tl::unexpected(free.error());
    if (const QString stray = strayPartOf(path); !stray.isEmpty())
        return failure(ErrorCode::FileUnwritable, path,
            QStringLiteral("'%1' lies beside it, which belongs to another session; move it away")
                .arg(stray));
    QFile empty(path);
    if (!empty.open(QIODevice::WriteOnly | QIODevice::NewOnly,
            QFileDevice::ReadOwner | QFileDevice::WriteOwner))
        return failure(ErrorCode::FileUnwritable, path, empty.errorString());
    empty.close();
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
    const QFileInfo info(path);
    if (!info.exists())
        return failure(ErrorCode::FileNotFound, path);
    if (info.isDir())
        return failure(ErrorCode::FileUnreadable, path, QStringLiteral("it is a folder"));
    if (const Result<void> plain = checkReadsToAnEnd(path); !plain)
        return tl::unexpected(plain.error());
    if (!info.isReadable())
        return failure(ErrorCode::FileUnreadable, path, QStringLiteral("permission denied"));
    if (info.size() == 0)
        return failure(ErrorCode::FileTruncated, path, QStringLiteral("it is empty"));
    if (access == Access::ReadWrite
        && !(info.isWritable() && QFileInfo(info.absolutePath()).isWritable()))
        return failure(ErrorCode::FileUnwritable, path,
            QStringLiteral("a session is written while it is open; copy it to a folder of yours"));
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
    const QFileInfo info(path);
    if (!info.isFile())
        return false;
    if (info.suffix().compare(QLatin1String("burin"), Qt::CaseInsensitive) == 0)
        return true;
    // One in use must not be opened as a plain file (SessionUse.h).
    if (isSessionInUse(path))
        return true;
    QFile file(path);
    return file.open(QIODevice::ReadOnly) && file.read(15) == "SQLite format 3";
}

void SessionFile::addRow(const HistoryRow& row)
{
    post({.carryOut = [text = RowText::of(row)](
                          SessionTables& tables) { return tables.addRow(text); },
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
            const auto waits = std::find_if(m_waiting.rbegin(), m_waiting.rend(),
                [row](const Write& write) { return !write.picture.isEmpty() && write.row == row; });
            if (waits != m_waiting.rend())
                take(waits->picture);
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
                take(tl::unexpected(*m_whyNoFile));
        },
        [take](const Error& error) { take(tl::unexpected(error)); });
}

void SessionFile::setDisplay(const QJsonObject& display)
{
    post({.carryOut = [display](SessionTables& tables) { return tables.setDisplay(display); }});
}

void SessionFile::post(Write write)
{
    // Made here, so that there is nothing on the other side for which memory may be short.
    const auto written = std::make_shared<std::list<Write>>();
    written->push_back(std::move(write));
    m_writer.post(
        [this, written] {
            m_waiting.splice(m_waiting.end(), *written);
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
            if (!m_tables && !whyNoFile())
                static_cast<void>(reopen(path()));
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
    m_tables.reset(); // one file, with nothing beside it
    StagedFile staged = StagedFile::adopt(m_path, target);
    const Result<void> placed = staged.commit();
    if (!placed)
        staged.release();
    const QString path = placed ? target : m_path;
    // Why it could not be placed is what there is to tell, whatever follows from it.
    if (const Result<void> opened = reopen(path); !opened)
        return placed ? opened : placed;
    const std::lock_guard lock(m_mutex);
    m_path = path;
    return placed;
}

void SessionFile::copyTo(const QString& path, std::function<void(const Result<void>&)> done)
{
    m_writer.post(
        [this, path, done] {
            writeWaiting();
            const Result<void> copied = guarded([&] { return copyInto(path, {.kept = false}); });
            if (!copied)
                removeSession(path);
            done(copied);
        },
        [done](const Error& error) { done(tl::unexpected(error)); });
}

/// Into a staged file that is empty, or holds images and nothing else; with what waits.
Result<void> SessionFile::copyInto(const QString& path, const SavedImages& images)
{
    const bool leavesOut = m_tables && m_tables->holdsImages() && !images.kept;
    const bool begun = images.staged || leavesOut || !m_tables;
    if (begun && !images.staged) {
        SessionTables empty(path);
        if (const Result<void> made = empty.create(m_contents.source); !made)
            return made;
    }
    if (m_tables) {
        const Result<void> copied =
            begun ? m_tables->copyHistoryInto(path) : m_tables->copyInto(path);
        if (!copied)
            return copied;
    }
    // Opened as any session is: rows and chain are there.
    SessionTables copy(path);
    if (const Result<SessionContents> read = copy.open(Access::ReadWrite); !read)
        return tl::unexpected(read.error());
    for (const Write& write : m_waiting) {
        if (const Result<void> written = write.carryOut(copy); !written)
            return written;
    }
    return {};
}

/// On the writer's thread.
Result<void> SessionFile::moveTo(
    const QString& target, bool replaceExisting, const SavedImages& images)
{
    const bool ownPlace = m_tables && !m_isPrivateCopy && QFileInfo::exists(target)
        && QFileInfo(target).canonicalFilePath() == QFileInfo(m_path).canonicalFilePath();
    if (!ownPlace && QFileInfo::exists(target) && isSessionInUse(target))
        return failure(ErrorCode::FileUnwritable, target, inUse);
    // What its program could not write any more would be taken for the new file's.
    if (!ownPlace && isSessionUnfinished(target))
        return failure(ErrorCode::FileUnwritable, target,
            QStringLiteral("it was not closed properly; open it once, or take another name"));
    std::shared_ptr<StagedFile> staged = images.staged;
    if (!staged) {
        Result<StagedFile> made = StagedFile::create(target, replaceExisting, ownPlace);
        if (!made)
            return tl::unexpected(made.error());
        staged = std::make_shared<StagedFile>(*std::move(made));
        QFile::setPermissions(staged->path(), QFileDevice::ReadOwner | QFileDevice::WriteOwner);
    }
    const QString path = staged->path();
    if (const Result<void> whole = copyInto(path, images); !whole) {
        removeSession(path);
        return failure(whole.error().code, target, whole.error().arguments.value(1));
    }
    if (ownPlace)
        m_tables.reset(); // nothing of the old file is to lie beside the new one
    if (const Result<void> placed = staged->commit(); !placed) {
        if (ownPlace)
            static_cast<void>(reopen(m_path));
        return placed;
    }
    if (const Result<void> opened = reopen(target); !opened)
        return opened;
    m_waiting.clear();
    {
        const std::lock_guard lock(m_mutex);
        m_path = target;
        m_isPrivateCopy = false;
        m_whyNoFile.reset();
        m_holdsImages = m_tables->holdsImages();
    }
    setTrouble({});
    return {};
}

/// On the writer's thread. Where it fails and nothing is open, work goes on in memory.
Result<void> SessionFile::reopen(const QString& path)
{
    auto tables = std::make_unique<SessionTables>(path);
    if (const Result<SessionContents> read = tables->open(Access::ReadWrite); !read) {
        if (!m_tables) {
            const std::lock_guard lock(m_mutex);
            m_whyNoFile = read.error();
        }
        return tl::unexpected(read.error());
    }
    m_tables = std::move(tables);
    return {};
}

void SessionFile::retry()
{
    m_writer.post([this] { writeWaiting(); }, [this](const Error& error) { setTrouble(error); });
}

void SessionFile::writeWaiting()
{
    std::optional<Error> trouble;
    if (!m_tables) {
        const bool anyStep = std::any_of(
            m_waiting.begin(), m_waiting.end(), [](const Write& write) { return write.isStep; });
        return setTrouble(anyStep ? m_whyNoFile : std::nullopt);
    }
    while (!m_waiting.empty() && !trouble) {
        if (const Result<void> written = carryOutFirst(); written)
            m_waiting.pop_front();
        else
            trouble = written.error();
    }
    setTrouble(trouble);
}

Result<void> SessionFile::carryOutFirst()
{
    Result<void> written = guarded([this] { return m_waiting.front().carryOut(*m_tables); });
    // It waits like what the disk does not take.
    if (!written && written.error().code != ErrorCode::FileUnwritable)
        written.error() = {ErrorCode::FileUnwritable, {m_path, written.error().arguments.value(0)}};
    return written;
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
        if (waits != m_waiting.end())
            result = *waits->delta;
        else if (m_tables)
            result = m_tables->readDelta(row);
        else
            result = tl::unexpected(*m_whyNoFile);
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
