// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/RowText.h"
#include "core/session/SessionContents.h"
#include "core/session/SessionDatabase.h"

#include <memory>
#include <optional>
#include <vector>

namespace core {

/// What stands in the tables of a session file: written in transactions, read with its chain
/// checked. Part of SessionFile; belongs to its writer's thread.
class SessionTables {
public:
    explicit SessionTables(QString path);

    /// @pre the file exists and is empty
    [[nodiscard]] Result<void> create(const SessionSource& source);
    [[nodiscard]] Result<SessionContents> open(bool readOnly);

    void addRow(const RowText& row);
    void completeRow(RowId row, const QByteArray& stateHash, const BrickDelta& delta);
    void setPosition(RowId position);
    void setHiddenSegments(const std::vector<int>& labels);
    /// The first failure of those above. After it nothing more is written: a row must not stand on
    /// one that is missing.
    [[nodiscard]] Result<void> written() const;

    [[nodiscard]] Result<BrickDelta> readDelta(RowId row);

private:
    [[nodiscard]] tl::unexpected<Error> damaged(RowId row, const QString& reason) const;
    bool write(const std::function<bool()>& work);
    bool writePosition(RowId position);
    bool writeState(const QString& key, const QString& value);

    [[nodiscard]] Result<SessionSource> readSource();
    [[nodiscard]] Result<std::vector<HistoryRow>> readRows();
    [[nodiscard]] Result<HistoryRow> readRow(const QSqlQuery& answer, RowId expectedId);
    [[nodiscard]] Result<void> readState(SessionContents& contents);

    QString m_path;
    std::unique_ptr<SessionDatabase> m_database;
    std::vector<QString> m_chains; ///< by row; [0] is the source's
    std::optional<Error> m_error;
};

} // namespace core
