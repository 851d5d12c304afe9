// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/TaskThread.h"
#include "core/brick/BrickDelta.h"
#include "core/session/SessionContents.h"

#include <QString>

#include <memory>
#include <vector>

namespace core {

class SessionTables;

/// The history on disk (README.md beside this file): an SQLite database behind one writer thread
/// that owns the connection. Writing calls return at once and are carried out in order; the first
/// one that fails is told by flush(). Any thread may call.
class SessionFile {
public:
    /// A new file, readable by its owner only.
    /// Errors: FileExists (unless @p replaceExisting), FileUnwritable.
    static Result<std::unique_ptr<SessionFile>> create(
        const QString& path, const SessionSource& source, bool replaceExisting);

    enum class Access { ReadWrite, ReadOnly };
    /// Checks the chain of all rows; read-only media are fine with Access::ReadOnly.
    /// Errors: FileNotFound, FileUnreadable (in use by another program), FileTruncated (empty),
    /// FileUnwritable, UnsupportedFormat (no session, or a newer Burin's), SessionDamaged.
    static Result<std::unique_ptr<SessionFile>> open(const QString& path, Access access);

    /// Whether a path is to be opened as a session, by name (.burin) or content: it may still be
    /// damaged, or not be one.
    [[nodiscard]] static bool isNamedAt(const QString& path);

    /// Writes what is waiting and leaves one file.
    ~SessionFile();

    /// As it was when the file was opened.
    [[nodiscard]] const SessionContents& contents() const { return m_contents; }
    [[nodiscard]] QString path() const { return m_path; }

    /// First half of a row: it becomes the position, and the child that redo goes to.
    void addRow(const HistoryRow& row);
    /// Second half.
    void completeRow(RowId row, const QByteArray& stateHash, const BrickDelta& delta);
    void setPosition(RowId position);
    void setHiddenSegments(const std::vector<int>& labels);

    /// Waits. Errors: SessionDamaged.
    [[nodiscard]] Result<BrickDelta> readDelta(RowId row);
    /// Waits until everything is on disk. Errors: FileUnwritable, from the first failure on
    /// (nothing more is written then: a row must not stand on one that is missing).
    [[nodiscard]] Result<void> flush();

private:
    explicit SessionFile(const QString& path);

    QString m_path;
    SessionContents m_contents;
    std::unique_ptr<SessionTables> m_tables; ///< the writer's thread only
    TaskThread m_writer; ///< last: it uses all of the above
};

} // namespace core
