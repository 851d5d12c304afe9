// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/database/SessionDatabase.h"

#include "core/base/Guarded.h"
#include "core/sessionfile/database/SessionSchema.h"

#include <QFileInfo>
#include <QSqlQuery>
#include <QStorageInfo>
#include <QTemporaryDir>
#include <QUrl>

#include <utility>

namespace core {

namespace {

/// WAL needs shared memory and honest locks, which network file systems do not give.
bool isNetworkFileSystem(const QString& path)
{
    const QByteArray type = QStorageInfo(QFileInfo(path).absolutePath()).fileSystemType();
    for (const char* network : {"nfs", "cifs", "smb", "9p", "afs", "ncp", "fuse.sshfs", "ceph"}) {
        if (type.startsWith(network))
            return true;
    }
    return false;
}

/// Where SQLite puts it: beside the file itself, not beside a link to it.
QString walOf(const QString& file)
{
    return QFileInfo(file).canonicalFilePath() + QLatin1String("-wal");
}

/// How often closing a file is tried if the disk fails.
constexpr int closingTries = 3;

const auto notForWriting = QStringLiteral("unable to open database file for writing");

} // namespace

SessionDatabase::SessionDatabase(QString path)
    : m_path(std::move(path))
    , m_file(m_path)
{
}

SessionDatabase::~SessionDatabase()
{
    // What cannot be left in order here is recovered by whoever opens the file next.
    static_cast<void>(guarded([this] { leaveWal(); }));
}

/// Leaving WAL checkpoints it and removes the file beside. A disk that failed once is asked again:
/// closing alone would write back what is there, and leave the file to say that more is missing.
void SessionDatabase::leaveWal()
{
    // SQLite leaves WAL by the name that it knows, which may belong to another session by now.
    if (!m_followed.isAt(m_file) && !m_hasLeftName)
        return leaveWalOfLostName();
    bool left = m_readOnly || m_hasLeftName || !m_connection.wasOpened();
    for (int i = 0; !left && i < closingTries; ++i) {
        // The last thing that leaving writes is the mode: it is entered again to be left again.
        if (i > 0)
            run(QStringLiteral("PRAGMA journal_mode=WAL"));
        QString mode;
        const bool asked = query(
            QStringLiteral("PRAGMA journal_mode=DELETE"), {}, [&mode](const QSqlQuery& answer) {
                mode = answer.value(0).toString();
                return true;
            });
        left = asked && mode == QLatin1String("delete");
    }
    // It says still that its last writes are in the file beside it, which has gone meanwhile.
    if (!left && run(QStringLiteral("PRAGMA journal_mode=WAL")))
        static_cast<void>(m_connection.number("user_version"));
}

/// For a file that another program has renamed. If the disk does not let the last writes be put
/// into the file itself, their file (-wal) is renamed with it: otherwise it would be opened without
/// them. If it cannot be, and another file has the former name, it must not stay there: SQLite
/// would take it for that one's.
void SessionDatabase::leaveWalOfLostName()
{
    bool isWhole = false;
    for (int i = 0; !isWhole && i < closingTries; ++i)
        static_cast<void>(guarded([&] { isWhole = gather(); }));
    const QString file = m_followed.path();
    const bool isBesideIt = goesWith(file);
    if (isWhole && isBesideIt)
        return closeAt(file);
    if (isWhole)
        return leaveName({});
    if (isBesideIt)
        return;
    if (!QFileInfo::exists(m_file) || !m_wal.isAt(walOf(m_file)))
        return;
    // Files that were left there earlier keep their names.
    constexpr int mostLeft = 1000;
    for (int i = 1; i <= mostLeft; ++i) {
        if (moveSessionPart(m_wal, leftLogName(QFileInfo(m_file).canonicalFilePath(), i)))
            return;
    }
}

/// Everything is in the file itself, which says still that its last writes are in the one beside
/// it: opened and closed by the name that it has now, it is a single file. If the disk does not let
/// it be, the one beside it stays, empty, and nobody asks for it.
void SessionDatabase::closeAt(const QString& file)
{
    m_connection.close();
    m_use = SessionUse();
    // SQLite would make one that is not there any more.
    if (m_followed.isAt(file))
        static_cast<void>(open(file, false));
}

/// Renames the file of last writes with the file that was renamed. @return whether it is there now
bool SessionDatabase::goesWith(const QString& file) const
{
    return !file.isEmpty() && moveSessionPart(m_wal, file + QLatin1String("-wal"));
}

Result<std::unique_ptr<SessionDatabase>> SessionDatabase::create(
    const QString& path, const std::function<bool(SessionDatabase&)>& begin)
{
    std::unique_ptr<SessionDatabase> database(new SessionDatabase(path));
    Result<SessionUse> use = SessionUse::begin(path);
    if (!use)
        return tl::unexpected(use.error());
    database->m_use = *std::move(use);
    database->m_followed = FollowedFile(path);
    if (const Result<void> connected = database->connect(path, {}); !connected)
        return tl::unexpected(connected.error());
    if (database->m_connection.isForReading())
        return failure(ErrorCode::FileUnwritable, path, notForWriting);
    // The tables are made in rollback mode, so that the file alone is a session from the start.
    const bool made = database->transaction([&database, &begin] {
        return createSessionTables(database->m_connection)
            && database->run(QStringLiteral("PRAGMA application_id=%1").arg(applicationId))
            && begin(*database);
    });
    if (!made)
        return database->failed();
    if (const Result<void> writing = database->beginWriting(); !writing)
        return tl::unexpected(writing.error());
    return database;
}

Result<std::unique_ptr<SessionDatabase>> SessionDatabase::open(const QString& path, bool readOnly)
{
    std::unique_ptr<SessionDatabase> database(new SessionDatabase(path));
    database->m_readOnly = readOnly;
    database->m_loss = sessionLoss(path);
    database->m_connection.explainBy(database->m_loss.cutOff);
    QString name = path;
    QString options;
    if (!readOnly && !database->m_loss.cutOff.isEmpty())
        return failure(ErrorCode::SessionDamaged, path, database->m_loss.cutOff);
    if (!readOnly) {
        Result<SessionUse> use = SessionUse::begin(path);
        if (!use)
            return tl::unexpected(use.error());
        database->m_use = *std::move(use);
        database->m_followed = FollowedFile(path);
    } else if (isSessionInUse(path) || isSessionUnfinished(path)) {
        const Result<QString> copy = database->copyPrivately();
        if (!copy)
            return tl::unexpected(copy.error());
        name = *copy;
    } else {
        // A finished file cannot change under us; "immutable" spares lock files on read-only media.
        QUrl url = QUrl::fromLocalFile(QFileInfo(path).absoluteFilePath());
        url.setQuery(QStringLiteral("mode=ro&immutable=1"));
        name = QString::fromLatin1(url.toEncoded());
        options = QStringLiteral("QSQLITE_OPEN_READONLY;QSQLITE_OPEN_URI");
    }
    if (const Result<void> connected = database->connect(name, options); !connected)
        return tl::unexpected(connected.error());
    if (!readOnly && database->m_connection.isForReading() && QFileInfo(path).isWritable())
        return failure(ErrorCode::FileUnwritable, path, notForWriting);
    if (!database->m_loss.cutOff.isEmpty())
        database->m_connection.readCutOff();
    if (const Result<void> checked = database->checkFormat(); !checked)
        return tl::unexpected(checked.error());
    if (!readOnly) {
        // Nothing has been written by then: what is refused stays as it is.
        if (const Result<void> sound = database->checkStructure(); !sound)
            return tl::unexpected(sound.error());
        if (const Result<void> writing = database->beginWriting(); !writing)
            return tl::unexpected(writing.error());
    }
    return database;
}

Result<std::unique_ptr<SessionDatabase>> SessionDatabase::openCopy(const QString& path)
{
    std::unique_ptr<SessionDatabase> database(new SessionDatabase(path));
    database->m_loss = sessionLoss(path);
    database->m_connection.explainBy(database->m_loss.cutOff);
    if (!database->m_loss.cutOff.isEmpty())
        return failure(ErrorCode::SessionDamaged, path, database->m_loss.cutOff);
    const Result<QString> copy = database->copyPrivately();
    if (!copy)
        return tl::unexpected(copy.error());
    if (const Result<void> connected = database->connect(*copy, {}); !connected)
        return tl::unexpected(connected.error());
    if (const Result<void> checked = database->checkFormat(); !checked)
        return tl::unexpected(checked.error());
    if (const Result<void> sound = database->checkStructure(); !sound)
        return tl::unexpected(sound.error());
    if (const Result<void> writing = database->beginWriting(); !writing)
        return tl::unexpected(writing.error());
    return database;
}

Result<QString> SessionDatabase::copyPrivately()
{
    m_copy = std::make_unique<QTemporaryDir>(); // for its owner only
    if (!m_copy->isValid())
        return failure(ErrorCode::FileUnreadable, m_path,
            Clause::saying("no room for a private copy: %1", m_copy->errorString()));
    const QString copy = m_copy->filePath(QStringLiteral("session.burin"));
    if (const Result<void> copied = copySession(m_path, copy); !copied)
        return tl::unexpected(copied.error());
    m_file = copy;
    return copy;
}

Result<void> SessionDatabase::connect(const QString& name, const QString& options)
{
    if (!m_connection.open(name, options, m_file))
        return failure(
            m_readOnly ? ErrorCode::FileUnreadable : ErrorCode::FileUnwritable, m_path, reason());
    if (!m_connection.harden())
        return failed();
    if (!m_readOnly && !run(QStringLiteral("PRAGMA locking_mode=EXCLUSIVE")))
        return failed();
    return {};
}

Result<void> SessionDatabase::checkFormat()
{
    const int application = m_connection.number("application_id");
    if (application < 0)
        return failed();
    if (application != applicationId && !m_loss.cutOff.isEmpty())
        return failure(ErrorCode::SessionDamaged, m_path, m_loss.cutOff);
    if (application != applicationId)
        return failure(
            ErrorCode::UnsupportedFormat, m_path, Clause::saying("it is no session of Burin"));
    const int version = m_connection.number("user_version");
    if (version < SessionFormat::oldest || version > SessionFormat::newest)
        return failure(ErrorCode::UnsupportedFormat, m_path,
            version > SessionFormat::newest
                ? Clause::saying("a newer Burin wrote it (session format %1; this one reads %2)",
                    version, int(SessionFormat::newest))
                : Clause::saying("sessions of format %1 are not known here", version));
    return checkSchema(version);
}

Result<void> SessionDatabase::checkSchema(int format)
{
    SchemaDeviations deviations;
    if (!readSchemaDeviations(m_connection, format, deviations))
        return failed();
    // Of one that is cut off what is there is read.
    if (!m_loss.cutOff.isEmpty())
        return {};
    if (!deviations.table.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, m_path,
            Clause::saying("its table '%1' is not that of a session", deviations.table));
    if (deviations.foreign.isEmpty())
        return {};
    m_loss.foreign =
        Clause::saying("it holds a %1, which is no part of a session", deviations.foreign);
    return m_readOnly ? Result<void>() : failure(ErrorCode::SessionDamaged, m_path, m_loss.foreign);
}

Result<void> SessionDatabase::checkStructure()
{
    // A larger one holds a study's images, whose pieces have hashes; reading all of it would take
    // long.
    constexpr std::int64_t most = 64 << 20;
    if (!m_loss.cutOff.isEmpty() || m_connection.bytesOnDisk() > most)
        return {};
    QString said;
    const bool read =
        query(QStringLiteral("PRAGMA quick_check(1)"), {}, [&said](const QSqlQuery& answer) {
            said = answer.value(0).toString();
            return true;
        });
    if (read && said == QLatin1String("ok"))
        return {};
    m_loss.structure = Clause::saying(
        "its structure is damaged: %1", (read ? said : reason()).simplified().left(200));
    return m_readOnly ? Result<void>()
                      : failure(ErrorCode::SessionDamaged, m_path, m_loss.structure);
}

Result<void> SessionDatabase::beginWriting()
{
    // Taking the lock now tells at once that another program has the session open.
    if (!run(QStringLiteral("BEGIN EXCLUSIVE")) || !run(QStringLiteral("COMMIT")))
        return failed();
    const QString journal =
        isNetworkFileSystem(m_path) ? QStringLiteral("TRUNCATE") : QStringLiteral("WAL");
    if (!run(QStringLiteral("PRAGMA journal_mode=") + journal)
        || !run(QStringLiteral("PRAGMA synchronous=FULL")))
        return failed();
    // The file says from now on that its last writes are in the one beside it, which SQLite makes
    // at the first access only: until then a program that is killed would leave a session that
    // seems to lack something.
    if (m_connection.number("user_version") < 0)
        return failed();
    m_wal = FollowedFile(walOf(m_file));
    return {};
}

bool SessionDatabase::gather()
{
    // A checkpoint that somebody holds up succeeds as a statement, and says so in its answer.
    bool isWhole = false;
    return query(QStringLiteral("PRAGMA wal_checkpoint(TRUNCATE)"), {},
               [&isWhole](const QSqlQuery& answer) {
                   isWhole = answer.value(0).toInt() == 0;
                   return true;
               })
        && isWhole;
}

void SessionDatabase::leaveName(const QString& now)
{
    m_hasLeftName = true;
    if (!goesWith(now))
        removeSessionPart(m_wal);
}

bool SessionDatabase::run(const QString& sql, const QVariantList& values)
{
    return m_connection.run(sql, values);
}

bool SessionDatabase::query(const QString& sql, const QVariantList& values,
    const std::function<bool(const QSqlQuery&)>& take)
{
    return m_connection.query(sql, values, take);
}

bool SessionDatabase::transaction(const std::function<bool()>& work)
{
    return m_connection.transaction(work);
}

Clause SessionDatabase::reason() const
{
    // SQLITE_READONLY: what SQLite may not write, or cannot open for writing, it opens for reading.
    const bool isForReading = (m_connection.failure().code.toInt() & 0xFF) == 8;
    return isForReading ? Clause(notForWriting) : m_connection.failure().reason;
}

bool SessionDatabase::makeRoomForTitles()
{
    return core::makeRoomForTitles(m_connection);
}

bool SessionDatabase::copyInto(const QString& path)
{
    return run(QStringLiteral("VACUUM INTO ?"), {path});
}

bool SessionDatabase::copyHistoryInto(const QString& path)
{
    return copyHistoryTables(m_connection, path);
}

std::optional<Error> SessionDatabase::failureOutside() const
{
    switch (m_connection.failure().code.toInt() & 0xFF) {
    case 10: // SQLITE_IOERR
    case 14: // SQLITE_CANTOPEN
        return failed().value();
    default:
        return std::nullopt;
    }
}

tl::unexpected<Error> SessionDatabase::failed() const
{
    if (!m_loss.cutOff.isEmpty())
        return failure(ErrorCode::SessionDamaged, m_path, m_loss.cutOff);
    // https://www.sqlite.org/rescode.html; extended codes carry the primary one in the low byte.
    switch (m_connection.failure().code.toInt() & 0xFF) {
    case 5: // SQLITE_BUSY
    case 6: // SQLITE_LOCKED
        return failure(ErrorCode::FileUnreadable, m_path,
            Clause::saying("it is open already, in this window or another program"));
    case 9: // SQLITE_INTERRUPT
    case 11: // SQLITE_CORRUPT
        return failure(ErrorCode::SessionDamaged, m_path, reason());
    case 26: // SQLITE_NOTADB
        return failure(
            ErrorCode::UnsupportedFormat, m_path, Clause::saying("it is no session of Burin"));
    case 8: // SQLITE_READONLY
    case 13: // SQLITE_FULL
        return failure(ErrorCode::FileUnwritable, m_path, reason());
    default:
        return failure(
            m_readOnly ? ErrorCode::FileUnreadable : ErrorCode::FileUnwritable, m_path, reason());
    }
}

} // namespace core
