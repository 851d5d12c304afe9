// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/database/SessionSchema.h"

#include "core/sessionfile/database/SqliteConnection.h"

#include <QSqlQuery>

#include <algorithm>
#include <iterator>
#include <map>

namespace core {

namespace {

/// What a session holds since its first format that is read here.
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
/// What rows say, for people of any language: by row, in no hash.
const char* const titleTable = "CREATE TABLE title (row INTEGER PRIMARY KEY, json TEXT NOT NULL)";

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
    {"title", "row, json"},
};

bool noteFormat(SqliteConnection& connection)
{
    return connection.run(QStringLiteral("PRAGMA user_version=%1").arg(SessionFormat::newest));
}

QString nameOf(const QString& table)
{
    return table.section(QLatin1Char(' '), 2, 2);
}

bool hasTable(SqliteConnection& connection, const char* name, bool& has)
{
    has = false;
    return connection.query(
        QStringLiteral("SELECT 1 FROM main.sqlite_master WHERE type='table' AND name=?"),
        {QLatin1String(name)}, [&has](const QSqlQuery&) { return has = true; });
}

} // namespace

bool createSessionTables(SqliteConnection& connection)
{
    return std::all_of(std::begin(tables), std::end(tables),
               [&connection](const char* table) { return connection.run(QLatin1String(table)); })
        && connection.run(QLatin1String(titleTable)) && noteFormat(connection);
}

bool makeRoomForTitles(SqliteConnection& connection)
{
    bool there = false;
    return hasTable(connection, "title", there)
        && (there || (connection.run(QLatin1String(titleTable)) && noteFormat(connection)));
}

bool readSchemaDeviations(SqliteConnection& connection, int format, SchemaDeviations& deviations)
{
    std::map<QString, QString> ours;
    for (const char* table : tables) {
        const QString text = QLatin1String(table);
        ours[nameOf(text)] = text;
    }
    // Of a file of before no table of this name is ours, and it would be read.
    const bool hasTitles = format >= SessionFormat::withTitles;
    ours[nameOf(QLatin1String(titleTable))] =
        hasTitles ? QString::fromLatin1(titleTable) : QString();
    return connection.query(
        QStringLiteral("SELECT type, name, substr(sql, 1, 2000) FROM sqlite_master"), {},
        [&](const QSqlQuery& answer) {
            const QString type = answer.value(0).toString();
            const QString name = answer.value(1).toString();
            const auto wanted = ours.find(name.toLower()); // as SQLite looks for it
            if (wanted != ours.end()) {
                if (type != QLatin1String("table") || answer.value(2).toString() != wanted->second)
                    deviations.table = name;
            } else if (!name.startsWith(QLatin1String("sqlite_autoindex_"))) {
                deviations.foreign = QStringLiteral("%1 '%2'").arg(type, name.left(60));
            }
            return deviations.table.isEmpty();
        });
}

bool copyHistoryTables(SqliteConnection& connection, const QString& target)
{
    if (!connection.run(QStringLiteral("ATTACH ? AS target"), {target}))
        return false;
    const bool copied = connection.transaction([&connection] {
        for (const CopiedTable& table : copiedTables) {
            bool there = false;
            if (!hasTable(connection, table.name, there))
                return false;
            // One of before has no titles.
            if (!there && table.name == QLatin1String("title"))
                continue;
            if (!connection.run(QStringLiteral("INSERT INTO target.%1 (%2) SELECT %2 FROM main.%1")
                                    .arg(QLatin1String(table.name), QLatin1String(table.columns))))
                return false;
        }
        return connection.run(
            QStringLiteral("UPDATE target.source SET json=(SELECT json FROM main.source)"));
    });
    const SqliteConnection::Failure failure = connection.failure();
    const bool left = connection.run(QStringLiteral("DETACH target"));
    if (!copied)
        connection.setFailure(failure);
    return copied && left;
}

} // namespace core
