// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/database/SqliteConnection.h"

#include "core/base/Guarded.h"
#include "core/base/files/SystemFile.h"
#include "core/sessionfile/database/RefusedWrites.h"

#include <QFileInfo>
#include <QSqlDatabase>
#include <QSqlDriver>
#include <QSqlError>
#include <QSqlQuery>

#include <atomic>
#include <new>

#include <sqlite3.h>

namespace core {

namespace {

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

/// How often SQLite asks whether a statement is to go on.
constexpr int instructionsAtOnce = 100'000;

/// As https://www.sqlite.org/security.html has it: no statement can harm the file's structure, and
/// nothing in it is larger than anything of ours ever is.
bool hardenHandle(sqlite3* handle)
{
    // Of a value, and of a row: masks that were read with a hundred segments are tens of megabytes.
    constexpr int mostBytes = 512 << 20;
    if (!handle)
        return false;
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    // Whoever cannot leave WAL in order, for want of memory or of a disk, leaves the file of last
    // writes where it is: closing alone would take it away, and the session would still ask for it.
    sqlite3_db_config(handle, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, mostBytes);
    sqlite3_limit(handle, SQLITE_LIMIT_TRIGGER_DEPTH, 0);
    return true;
}

/// In the system's words if it is the system that refused something: SQLite only says "disk I/O
/// error" if a quota is used up.
QString reasonOf(const QSqlError& error)
{
    const int code = error.nativeErrorCode().toInt();
    const int kind = code & 0xFF;
    // What could not be read is no matter of what the same statement could not write.
    const bool isOfReading = code == SQLITE_IOERR_READ || code == SQLITE_IOERR_SHORT_READ;
    const bool isOfSystem =
        (kind == SQLITE_IOERR && !isOfReading) || kind == SQLITE_FULL || kind == SQLITE_CANTOPEN;
    const int refused = isOfSystem ? lastRefusedWrite() : 0;
    return refused != 0 ? systemReason(refused) : error.databaseText();
}

} // namespace

SqliteConnection::SqliteConnection()
    : m_name(newConnectionName())
{
    noteRefusedWrites();
}

SqliteConnection::~SqliteConnection()
{
    close();
    QSqlDatabase::removeDatabase(m_name);
}

void SqliteConnection::close()
{
    QSqlDatabase::database(m_name, false).close();
}

bool SqliteConnection::open(const QString& name, const QString& options, const QString& file)
{
    m_file = file;
    QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), m_name);
    database.setDatabaseName(name);
    database.setConnectOptions(options.isEmpty()
            ? QStringLiteral("QSQLITE_BUSY_TIMEOUT=500")
            : options + QStringLiteral(";QSQLITE_BUSY_TIMEOUT=500"));
    forgetRefusedWrites();
    if (database.open())
        return true;
    m_failure.reason = reasonOf(database.lastError());
    return false;
}

bool SqliteConnection::harden()
{
    sqlite3* const handle = sqliteOf(QSqlDatabase::database(m_name, false));
    if (!run(QStringLiteral("PRAGMA trusted_schema=OFF")) || !hardenHandle(handle))
        return false;
    sqlite3_progress_handler(
        handle, instructionsAtOnce,
        [](void* self) { return static_cast<SqliteConnection*>(self)->goesOnForEver() ? 1 : 0; },
        this);
    return true;
}

bool SqliteConnection::wasOpened() const
{
    return QSqlDatabase::contains(m_name);
}

bool SqliteConnection::isForReading() const
{
    sqlite3* const handle = sqliteOf(QSqlDatabase::database(m_name, false));
    return handle && sqlite3_db_readonly(handle, "main") == 1;
}

void SqliteConnection::readCutOff()
{
    sqlite3_db_config(
        sqliteOf(QSqlDatabase::database(m_name, false)), SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr);
    run(QStringLiteral("PRAGMA writable_schema=ON"));
}

std::int64_t SqliteConnection::bytesOnDisk() const
{
    return QFileInfo(m_file).size() + QFileInfo(m_file + QLatin1String("-wal")).size();
}

/// A tree of pages in which many parents share a child has more rows than there are atoms. A sound
/// file gives a statement less than an instruction for each of its bytes.
bool SqliteConnection::goesOnForEver()
{
    constexpr std::int64_t always = 20'000'000;
    m_work += instructionsAtOnce;
    return m_work > always && m_work > always + 2 * bytesOnDisk();
}

int SqliteConnection::number(const char* pragma)
{
    int value = -1;
    query(QStringLiteral("PRAGMA ") + QLatin1String(pragma), {}, [&value](const QSqlQuery& answer) {
        value = answer.value(0).toInt();
        return true;
    });
    return value;
}

bool SqliteConnection::run(const QString& sql, const QVariantList& values)
{
    return query(sql, values, [](const QSqlQuery&) { return true; });
}

bool SqliteConnection::query(const QString& sql, const QVariantList& values,
    const std::function<bool(const QSqlQuery&)>& take)
{
    m_work = 0;
    forgetRefusedWrites();
    const QSqlDatabase database = QSqlDatabase::database(m_name, false);
    QSqlQuery statement(database);
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
        m_failure.reason =
            m_explanation.isEmpty() ? Clause(reasonOf(statement.lastError())) : m_explanation;
        m_failure.code = statement.lastError().nativeErrorCode();
        // What follows from it must not be taken for what the file says.
        if ((m_failure.code.toInt() & 0xFF) == 7) // SQLITE_NOMEM
            throw std::bad_alloc();
        if (m_failure.code == QLatin1String("9"))
            m_failure.reason = Clause::saying("reading it would not end");
        return false;
    }
    return good;
}

bool SqliteConnection::transaction(const std::function<bool()>& work)
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
    const Failure failure = m_failure;
    run(QStringLiteral("ROLLBACK"));
    m_failure = failure;
    return false;
}

} // namespace core
