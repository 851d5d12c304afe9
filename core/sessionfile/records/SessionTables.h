// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/sessionfile/database/SessionDatabase.h"
#include "core/sessionfile/records/RowText.h"
#include "core/sessionfile/records/SessionContents.h"

#include <functional>
#include <memory>
#include <vector>

namespace core {

/// The contents of the tables of a session file: written in transactions, and read as a whole
/// (SessionReading) or one by one. Part of SessionFile; belongs to its writer's thread.
class SessionTables {
public:
    explicit SessionTables(QString path);

    /// @pre the file exists and is empty
    [[nodiscard]] Result<void> create(const SessionSource& source);
    /// Errors: those of SessionFile::open().
    [[nodiscard]] Result<SessionContents> open(SessionAccess access);
    /// The present contents of an open file, with every hash of the rows checked again; damage is
    /// reported in them.
    [[nodiscard]] Result<SessionContents> readAgain();
    /// Copies everything into a file that is empty or does not exist.
    [[nodiscard]] Result<void> copyInto(const QString& path);
    /// Copies everything but the images into a session without rows.
    [[nodiscard]] Result<void> copyHistoryInto(const QString& path);
    [[nodiscard]] bool holdsImages();
    // As in SessionDatabase.
    [[nodiscard]] bool gather() { return m_database->gather(); }
    void leaveName(const QString& now) { m_database->leaveName(now); }
    [[nodiscard]] bool isOwnWal(const QString& path) const { return m_database->isOwnWal(path); }
    [[nodiscard]] Clause reason() const { return m_database->reason(); }

    // One transaction each. One that fails (FileUnwritable) leaves the file as it was and may be
    // tried again. A row may be written only when the one before it exists.
    [[nodiscard]] Result<void> addRow(const RowText& row);
    [[nodiscard]] Result<void> completeRow(
        RowId row, const QByteArray& stateHash, const BrickDelta& delta);
    [[nodiscard]] Result<void> setPosition(RowId position);
    [[nodiscard]] Result<void> setHiddenSegments(const std::vector<int>& labels);
    [[nodiscard]] Result<void> setDisplay(const QJsonObject& display);
    [[nodiscard]] Result<void> addKeyframe(const Keyframe& keyframe);

    [[nodiscard]] Result<BrickDelta> readDelta(RowId row);
    [[nodiscard]] QByteArray readKeyframe(RowId row); ///< empty: none

private:
    [[nodiscard]] tl::unexpected<Error> damaged(RowId row, const Clause& reason) const;
    [[nodiscard]] Result<void> write(const std::function<bool()>& work);
    bool writeTitle(const RowText& row);
    bool writePosition(RowId position);
    bool writeState(const QString& key, const QString& value);

    QString m_path;
    std::unique_ptr<SessionDatabase> m_database;
    std::vector<QString> m_chains; ///< by row; [0] is the source's
};

} // namespace core
