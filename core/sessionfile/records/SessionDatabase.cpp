// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/SessionDatabase.h"

#include "core/base/Guarded.h"

#include <QFileInfo>
#include <QSqlDatabase>
#include <QSqlDriver>
#include <QSqlError>
#include <QSqlQuery>
#include <QStorageInfo>
#include <QTemporaryDir>
#include <QUrl>

#include <atomic>
#include <map>
#include <new>
#include <utility>

#include <sqlite3.h>

namespace core {

namespace {

const char* const tables[]{
    R"(CREATE TABLE source (id INTEGER PRIMARY KEY CHECK (id = 1), json TEXT NOT NULL,
        images TEXT, imagesSha256 TEXT, headers BLOB))",
    R"(CREATE TABLE row (id INTEGER PRIMARY KEY, parent INTEGER NOT NULL, name TEXT NOT NULL,
        edit TEXT NOT NULL, statistics TEXT NOT NULL, growthGeneration INTEGER NOT NULL,
        chain TEXT NOT NULL, stateHash TEXT, deltaSha256 TEXT, seal TEXT,
        at TEXT, author TEXT, program TEXT))",
    R"(CREATE TABLE delta (row INTEGER NOT NULL, piece INTEGER NOT NULL, bytes BLOB NOT NULL,
        PRIMARY KEY (row, piece)))",
    "CREATE TABLE visited (parent INTEGER PRIMARY KEY, child INTEGER NOT NULL)",
    "CREATE TABLE state (key TEXT PRIMARY KEY, value TEXT NOT NULL)",
    "CREATE TABLE keyframe (row INTEGER PRIMARY KEY, at TEXT NOT NULL, png BLOB NOT NULL)",
    "CREATE TABLE pixels (piece INTEGER PRIMARY KEY, sha256 TEXT NOT NULL, bytes BLOB NOT NULL)",
};

/// What is copied into another session.
struct CopiedTable {
    const char* name;
    const char* columns;
};
const CopiedTable copiedTables[]{
    {"row",
        "id, parent, name, edit, statistics, growthGeneration, chain, stateHash, deltaSha256, "
        "seal, at, author, program"},
    {"delta", "row, piece, bytes"},
    {"visited", "parent, child"},
    {"state", "key, value"},
    {"keyframe", "row, at, png"},
};

QString newConnectionName()
{
    static std::atomic<int> count = 0;
    return QStringLiteral("burin.session.%1").arg(++count);
}

/// The connection that Qt's driver holds; it stays Qt's.
sqlite3* sqliteOf(const QSqlDatabase& database)
{
    const QVariant handle = database.driver()->handle();
    return handle.isValid() && qstrcmp(handle.typeName(), "sqlite3*") == 0
        ? *static_cast<sqlite3* const*>(handle.constData())
        : nullptr;
}

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

const auto notForWriting = QStringLiteral("unable to open database file for writing");

/// How often SQLite asks whether a statement is to go on.
constexpr int instructionsAtOnce = 100'000;

/// SQLite's own door for files by strangers (https://www.sqlite.org/security.html): no statement
/// can harm the file's structure, and nothing in it is larger than anything of ours ever is.
bool harden(const QSqlDatabase& database)
{
    // Of a value, and of a row: masks that were read with a hundred segments are tens of megabytes.
    constexpr int mostBytes = 512 << 20;
    sqlite3* const handle = sqliteOf(database);
    if (!handle)
        return false;
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, mostBytes);
    sqlite3_limit(handle, SQLITE_LIMIT_TRIGGER_DEPTH, 0);
    return true;
}

} // namespace

SessionDatabase::SessionDatabase(QString path)
    : m_path(std::move(path))
    , m_file(m_path)
    , m_connection(newConnectionName())
{
}

SessionDatabase::~SessionDatabase()
{
    // What cannot be left in order here is recovered by whoever opens the file next.
    static_cast<void>(guarded([this] { leaveWal(); }));
    QSqlDatabase::database(m_connection, false).close();
    QSqlDatabase::removeDatabase(m_connection);
}

/// Leaving WAL checkpoints it and removes the file beside. A disk that failed once is asked again:
/// closing alone would write back what is there, and leave the file to say that more is missing.
void SessionDatabase::leaveWal()
{
    constexpr int tries = 3;
    bool left = m_readOnly || !QSqlDatabase::contains(m_connection);
    for (int i = 0; !left && i < tries; ++i) {
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
}

/// Where the system refuses writing, SQLite opens a file for reading, and forgets why.
bool SessionDatabase::isForReading() const
{
    sqlite3* const handle = sqliteOf(QSqlDatabase::database(m_connection, false));
    return handle && sqlite3_db_readonly(handle, "main") == 1;
}

Result<std::unique_ptr<SessionDatabase>> SessionDatabase::create(const QString& path)
{
    std::unique_ptr<SessionDatabase> database(new SessionDatabase(path));
    Result<SessionUse> use = SessionUse::begin(path);
    if (!use)
        return tl::unexpected(use.error());
    database->m_use = *std::move(use);
    if (const Result<void> connected = database->connect(path, {}); !connected)
        return tl::unexpected(connected.error());
    if (database->isForReading())
        return failure(ErrorCode::FileUnwritable, path, notForWriting);
    // The tables are made in rollback mode, so that the file alone is a session from the start.
    const bool made = database->transaction([&database] {
        for (const char* table : tables) {
            if (!database->run(QLatin1String(table)))
                return false;
        }
        return database->run(QStringLiteral("PRAGMA application_id=%1").arg(applicationId))
            && database->run(QStringLiteral("PRAGMA user_version=%1").arg(schemaVersion));
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
    QString name = path;
    QString options;
    if (!readOnly && !database->m_loss.cutOff.isEmpty())
        return failure(ErrorCode::SessionDamaged, path, database->m_loss.cutOff);
    if (!readOnly) {
        Result<SessionUse> use = SessionUse::begin(path);
        if (!use)
            return tl::unexpected(use.error());
        database->m_use = *std::move(use);
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
    if (!readOnly && database->isForReading() && QFileInfo(path).isWritable())
        return failure(ErrorCode::FileUnwritable, path, notForWriting);
    // Else SQLite refuses a file that has fewer pages than it says.
    if (!database->m_loss.cutOff.isEmpty())
        database->readCutOff();
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
            QStringLiteral("no room for a private copy: ") + m_copy->errorString());
    const QString copy = m_copy->filePath(QStringLiteral("session.burin"));
    if (const Result<void> copied = copySession(m_path, copy); !copied)
        return tl::unexpected(copied.error());
    m_file = copy;
    return copy;
}

Result<void> SessionDatabase::connect(const QString& name, const QString& options)
{
    QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), m_connection);
    database.setDatabaseName(name);
    database.setConnectOptions(options.isEmpty()
            ? QStringLiteral("QSQLITE_BUSY_TIMEOUT=500")
            : options + QStringLiteral(";QSQLITE_BUSY_TIMEOUT=500"));
    if (!database.open()) {
        m_reason = database.lastError().databaseText();
        return failure(
            m_readOnly ? ErrorCode::FileUnreadable : ErrorCode::FileUnwritable, m_path, m_reason);
    }
    // Before the first statement that reads the schema.
    if (!run(QStringLiteral("PRAGMA trusted_schema=OFF")) || !harden(database))
        return failed();
    sqlite3_progress_handler(
        sqliteOf(database), instructionsAtOnce,
        [](void* self) { return static_cast<SessionDatabase*>(self)->goesOnForEver() ? 1 : 0; },
        this);
    if (!m_readOnly && !run(QStringLiteral("PRAGMA locking_mode=EXCLUSIVE")))
        return failed();
    return {};
}

Result<void> SessionDatabase::checkFormat()
{
    const int application = number("application_id");
    if (application < 0)
        return failed();
    if (application != applicationId && !m_loss.cutOff.isEmpty())
        return failure(ErrorCode::SessionDamaged, m_path, m_loss.cutOff);
    if (application != applicationId)
        return failure(
            ErrorCode::UnsupportedFormat, m_path, QStringLiteral("it is no session of Burin"));
    const int version = number("user_version");
    if (version != schemaVersion)
        return failure(ErrorCode::UnsupportedFormat, m_path,
            version > schemaVersion
                ? QStringLiteral("a newer Burin wrote it (session format %1; this one reads %2)")
                      .arg(version)
                      .arg(int(schemaVersion))
                : QStringLiteral("sessions of format %1 are not known here").arg(version));
    return checkSchema();
}

/// A session is data: what else a database may hold (triggers, views) would be run by whoever reads
/// or writes it.
Result<void> SessionDatabase::checkSchema()
{
    std::map<QString, QString> ours;
    for (const char* table : tables) {
        const QString text = QLatin1String(table);
        ours[text.section(QLatin1Char(' '), 2, 2)] = text;
    }
    QString other;
    QString foreign;
    const bool read = query(
        QStringLiteral("SELECT type, name, substr(sql, 1, 2000) FROM sqlite_master"), {},
        [&](const QSqlQuery& answer) {
            const QString type = answer.value(0).toString();
            const QString name = answer.value(1).toString();
            const auto wanted = ours.find(name);
            if (wanted != ours.end()) {
                if (type != QLatin1String("table") || answer.value(2).toString() != wanted->second)
                    other = name;
            } else if (!name.startsWith(QLatin1String("sqlite_autoindex_"))) {
                foreign = QStringLiteral("%1 '%2'").arg(type, name.left(60));
            }
            return other.isEmpty();
        });
    if (!read)
        return failed();
    // Of one that is cut off what is there is read.
    if (!m_loss.cutOff.isEmpty())
        return {};
    // One that is missing altogether is damage, which is told where it is read.
    if (!other.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, m_path,
            QStringLiteral("its table '%1' is not that of a session").arg(other));
    if (foreign.isEmpty())
        return {};
    m_loss.foreign = QStringLiteral("it holds a %1, which is no part of a session").arg(foreign);
    return m_readOnly ? Result<void>() : failure(ErrorCode::SessionDamaged, m_path, m_loss.foreign);
}

/// With what SQLite keeps beside it.
std::int64_t SessionDatabase::bytesOnDisk() const
{
    return QFileInfo(m_file).size() + QFileInfo(m_file + QLatin1String("-wal")).size();
}

/// A tree of pages in which many parents share a child has more rows than there are atoms. A sound
/// file gives a statement less than an instruction for each of its bytes.
bool SessionDatabase::goesOnForEver()
{
    constexpr std::int64_t always = 20'000'000;
    m_work += instructionsAtOnce;
    return m_work > always && m_work > always + 2 * bytesOnDisk();
}

Result<void> SessionDatabase::checkStructure()
{
    // A larger one holds a study's images, whose pieces have hashes; reading all of it would take
    // long.
    constexpr std::int64_t most = 64 << 20;
    if (!m_loss.cutOff.isEmpty() || bytesOnDisk() > most)
        return {};
    QString said;
    const bool read =
        query(QStringLiteral("PRAGMA quick_check(1)"), {}, [&said](const QSqlQuery& answer) {
            said = answer.value(0).toString();
            return true;
        });
    if (read && said == QLatin1String("ok"))
        return {};
    m_loss.structure = QStringLiteral("its structure is damaged: %1")
                           .arg((read ? said : m_reason).simplified().left(200));
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
    return {};
}

void SessionDatabase::readCutOff()
{
    sqlite3_db_config(sqliteOf(QSqlDatabase::database(m_connection, false)),
        SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr);
    run(QStringLiteral("PRAGMA writable_schema=ON"));
}

int SessionDatabase::number(const char* pragma)
{
    int value = -1;
    query(QStringLiteral("PRAGMA ") + QLatin1String(pragma), {}, [&value](const QSqlQuery& answer) {
        value = answer.value(0).toInt();
        return true;
    });
    return value;
}

bool SessionDatabase::run(const QString& sql, const QVariantList& values)
{
    return query(sql, values, [](const QSqlQuery&) { return true; });
}

bool SessionDatabase::query(const QString& sql, const QVariantList& values,
    const std::function<bool(const QSqlQuery&)>& take)
{
    m_work = 0;
    QSqlQuery statement(QSqlDatabase::database(m_connection, false));
    statement.setForwardOnly(true);
    bool good = statement.prepare(sql);
    if (good) {
        for (const QVariant& value : values)
            statement.addBindValue(value);
        good = statement.exec();
    }
    while (good && statement.next()) {
        if (!take(statement))
            break;
    }
    // A failure while stepping through an answer ends next() like the last row does.
    if (statement.lastError().isValid()) {
        m_reason = m_loss.cutOff.isEmpty() ? statement.lastError().databaseText() : m_loss.cutOff;
        m_code = statement.lastError().nativeErrorCode();
        // What follows from it must not be taken for what the file says.
        if ((m_code.toInt() & 0xFF) == 7) // SQLITE_NOMEM
            throw std::bad_alloc();
        if (m_code == QLatin1String("9"))
            m_reason = QStringLiteral("reading it would not end");
        return false;
    }
    return good;
}

bool SessionDatabase::transaction(const std::function<bool()>& work)
{
    if (!run(QStringLiteral("BEGIN IMMEDIATE")))
        return false;
    try {
        if (work() && run(QStringLiteral("COMMIT")))
            return true;
    } catch (...) {
        static_cast<void>(guarded([this] { run(QStringLiteral("ROLLBACK")); }));
        throw;
    }
    const QString reason = m_reason;
    const QString code = m_code;
    run(QStringLiteral("ROLLBACK"));
    m_reason = reason;
    m_code = code;
    return false;
}

bool SessionDatabase::copyInto(const QString& path)
{
    return run(QStringLiteral("VACUUM INTO ?"), {path});
}

bool SessionDatabase::copyHistoryInto(const QString& path)
{
    if (!run(QStringLiteral("ATTACH ? AS target"), {path}))
        return false;
    const bool copied = transaction([this] {
        for (const CopiedTable& table : copiedTables) {
            if (!run(QStringLiteral("INSERT INTO target.%1 (%2) SELECT %2 FROM main.%1")
                         .arg(QLatin1String(table.name), QLatin1String(table.columns))))
                return false;
        }
        return run(QStringLiteral("UPDATE target.source SET json=(SELECT json FROM main.source)"));
    });
    const QString reason = m_reason;
    const bool left = run(QStringLiteral("DETACH target"));
    if (!copied)
        m_reason = reason;
    return copied && left;
}

std::optional<Error> SessionDatabase::failureOutside() const
{
    switch (m_code.toInt() & 0xFF) {
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
    switch (m_code.toInt() & 0xFF) {
    case 5: // SQLITE_BUSY
    case 6: // SQLITE_LOCKED
        return failure(ErrorCode::FileUnreadable, m_path,
            QStringLiteral("it is open already, in this window or another program"));
    case 9: // SQLITE_INTERRUPT
    case 11: // SQLITE_CORRUPT
        return failure(ErrorCode::SessionDamaged, m_path, m_reason);
    case 26: // SQLITE_NOTADB
        return failure(
            ErrorCode::UnsupportedFormat, m_path, QStringLiteral("it is no session of Burin"));
    case 8: // SQLITE_READONLY
    case 13: // SQLITE_FULL
        return failure(ErrorCode::FileUnwritable, m_path, m_reason);
    default:
        return failure(
            m_readOnly ? ErrorCode::FileUnreadable : ErrorCode::FileUnwritable, m_path, m_reason);
    }
}

} // namespace core
