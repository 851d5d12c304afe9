// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/SessionSchema.h"

#include "core/sessionfile/records/SqliteConnection.h"

#include <QSqlQuery>

#include <algorithm>
#include <iterator>
#include <map>

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

} // namespace

bool createSessionTables(SqliteConnection& connection)
{
    return std::all_of(std::begin(tables), std::end(tables),
        [&connection](const char* table) { return connection.run(QLatin1String(table)); });
}

bool readSchemaDeviations(SqliteConnection& connection, SchemaDeviations& deviations)
{
    std::map<QString, QString> ours;
    for (const char* table : tables) {
        const QString text = QLatin1String(table);
        ours[text.section(QLatin1Char(' '), 2, 2)] = text;
    }
    return connection.query(
        QStringLiteral("SELECT type, name, substr(sql, 1, 2000) FROM sqlite_master"), {},
        [&](const QSqlQuery& answer) {
            const QString type = answer.value(0).toString();
            const QString name = answer.value(1).toString();
            const auto wanted = ours.find(name);
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
