// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

class SqliteConnection;

/// The tables of a session file. A session is data: what else a database may hold (triggers, views)
/// would be run by whoever reads or writes it.

/// Which tables a file has, by its `user_version`.
struct SessionFormat {
    static constexpr int oldest = 5; ///< that is read here
    static constexpr int withTitles = 6;
    static constexpr int newest = withTitles;
};

/// In the newest format. @return false: see the connection's failure()
bool createSessionTables(SqliteConnection& connection);

/// A file of before becomes one of the newest format when a row is written into it.
/// @return false: see the connection's failure()
bool makeRoomForTitles(SqliteConnection& connection);

/// Where a file's schema is not that of a session; empty: nowhere.
struct SchemaDeviations {
    QString table; ///< name of one that is not as it is created here
    QString foreign; ///< type and name of what a session does not have
};
/// One that is missing altogether is damage, which is told where it is read.
/// @return false: see the connection's failure()
bool readSchemaDeviations(SqliteConnection& connection, int format, SchemaDeviations& deviations);

/// Every table but the images into a session file that holds no row. The source's JSON is copied as
/// it stands, for the chain hangs on it. @return false: see the connection's failure()
bool copyHistoryTables(SqliteConnection& connection, const QString& target);

} // namespace core
