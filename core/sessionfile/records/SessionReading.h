// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/words/Clause.h"
#include "core/sessionfile/records/SessionContents.h"

#include <QLatin1String>
#include <QString>

#include <vector>

class QSqlQuery;

namespace core {

class SessionDatabase;

/// The key in the table `state` under which a session file says how many rows it has, and the chain
/// of the last one: "12 9f86d0…". Files of older builds have no such line.
inline constexpr QLatin1String sessionEndKey("end");

/// Whether the file holds the images of its study.
[[nodiscard]] bool holdsImages(SessionDatabase& database);

/// Reads the tables of a session file once, from the source to the last row, and checks every hash
/// on the way. Damage is no error as long as the source is readable: the contents end before it and
/// report it. One thread, that of the database.
class SessionReading {
public:
    /// @param path of the file, for messages
    SessionReading(SessionDatabase& database, QString path);

    /// Errors: SessionDamaged (the source cannot be read), or why the file could not be read at
    /// all, if its content is not to blame. To be called once.
    [[nodiscard]] Result<SessionContents> read();

    /// The chains of the rows that were read (RowText::chain()), by row; [0] is the source's. Empty
    /// if read() failed.
    [[nodiscard]] const std::vector<QString>& chains() const { return m_chains; }
    /// Whether the table of differences could be read; each difference is checked when it is used.
    [[nodiscard]] bool areDeltasReadable() const { return m_deltasReadable; }

private:
    [[nodiscard]] Result<SessionSource> readSource();
    void readRows(SessionContents& contents);
    /// Read separately, so that damage there costs no row: the row can be carried out again.
    void readDeltaSizes(SessionContents& contents);
    /// The row, or the reason why it cannot be trusted.
    [[nodiscard]] tl::expected<HistoryRow, Clause> readRow(
        const QSqlQuery& answer, RowId expectedId);
    void readState(SessionContents& contents);
    /// Checks that the last row is the one that @p end names. @return why that is impossible
    [[nodiscard]] Clause checkEnd(const QString& end, SessionContents& contents);
    void readKeyframes(SessionContents& contents);
    void readTitles(SessionContents& contents);
    [[nodiscard]] SessionDamage damageAt(RowId row, const Clause& reason);

    SessionDatabase& m_database;
    QString m_path;
    std::vector<QString> m_chains;
    bool m_deltasReadable = true;
};

} // namespace core
