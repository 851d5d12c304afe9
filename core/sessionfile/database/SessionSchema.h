// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

class SqliteConnection;

/// Which tables a file has, by its `user_version`.
struct SessionFormat {
    static constexpr int oldest = 5; ///< that is read here
    static constexpr int withTitles = 6;
    static constexpr int newest = withTitles;
};

// The tables of a session file. A session is data only: anything else that a database may hold
// (triggers, views) would be executed by its readers and writers.

/// @return false: see the connection's failure()
bool createSessionTables(SqliteConnection& connection);

/// Gives a file of an older format the table of titles, which makes it one of the newest format.
/// Called when a row is written into it.
/// @return false: see the connection's failure()
bool makeRoomForTitles(SqliteConnection& connection);

/// How a file's schema differs from that of a session; all empty: it does not.
struct SchemaDeviations {
    QString table; ///< name of a table that differs from the one created here
    QString foreign; ///< type and name of something that no session has
};
/// A missing table is damage, which is reported when it is read.
/// @return false: see the connection's failure()
bool readSchemaDeviations(SqliteConnection& connection, int format, SchemaDeviations& deviations);

/// Copies every table but the images into a session file without rows. The source's JSON is copied
/// verbatim, since the chain depends on it.
/// @return false: see the connection's failure()
bool copyHistoryTables(SqliteConnection& connection, const QString& target);

} // namespace core
