// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/files/FollowedFile.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/database/SqliteConnection.h"

#include <QString>
#include <QVariant>

#include <functional>
#include <memory>
#include <optional>

class QSqlQuery;
class QTemporaryDir;

namespace core {

/// A session file as a database: opened, checked, locked and closed (core/session/README.md). It
/// knows nothing of rows. It belongs to the thread that created it. A file that was built so that
/// reading it would never end counts as damaged.
class SessionDatabase {
public:
    static constexpr int applicationId = 0x4275726E; // "Burn"

    /// Makes the tables, and in the same transaction calls @p begin, which writes what the file
    /// holds from the start: a program that is killed leaves an empty file, or one that holds it.
    /// @param begin false: it could not be written, see reason()
    /// @pre the file exists and is empty
    static Result<std::unique_ptr<SessionDatabase>> create(
        const QString& path, const std::function<bool(SessionDatabase&)>& begin);
    /// @param readOnly neither the file nor its folder is changed; a file that is in use or was not
    /// closed is read from a private copy. A file that is cut off can only be read.
    static Result<std::unique_ptr<SessionDatabase>> open(const QString& path, bool readOnly);
    /// Opens a private copy for writing; it is deleted with this object.
    static Result<std::unique_ptr<SessionDatabase>> openCopy(const QString& path);
    ~SessionDatabase(); ///< leaves a single file

    /// Runs one statement with its values for `?`. @return false: see reason()
    bool run(const QString& sql, const QVariantList& values = {});
    /// Calls @p take for every row of the answer, until it returns false.
    bool query(const QString& sql, const QVariantList& values,
        const std::function<bool(const QSqlQuery&)>& take);
    /// Runs @p work in one transaction, which is rolled back if it returns false.
    bool transaction(const std::function<bool()>& work);
    /// Gives a file of an older format the table of titles. To be called in the transaction that
    /// writes a row, before the row.
    bool makeRoomForTitles();
    /// Checks the structure of a file of ordinary size (PRAGMA quick_check) and notes in loss()
    /// what is wrong. It is done automatically before a file is written. Errors, if the file is to
    /// be written: SessionDamaged.
    [[nodiscard]] Result<void> checkStructure();
    /// Copies everything into another file that is empty or does not exist.
    bool copyInto(const QString& path);
    /// Copies every table but the images into a session file without rows. The source's JSON is
    /// copied verbatim, since the chain depends on it.
    bool copyHistoryInto(const QString& path);

    // Of a file that another program has renamed, deleted or replaced while it was open for
    // writing:
    /// Puts everything into the file itself. @return false: see reason()
    [[nodiscard]] bool gather();
    /// Leaves nothing beside the file's old name. The connection works until it is destroyed, but
    /// what is written to it from here on is lost.
    /// @param now where the file is, if everything was put into it: its write-ahead log, which is
    /// empty, is moved there, so that none is missing if the file is not opened again; empty: the
    /// log is removed
    void leaveName(const QString& now);
    /// Whether @p path, beside some session, is its own write-ahead log.
    [[nodiscard]] bool isOwnWal(const QString& path) const
    {
        return m_wal.isValid() && m_wal.isAt(path);
    }

    [[nodiscard]] Clause reason() const;
    /// What the file lacks. Of a file that is cut off, the existing part is read.
    [[nodiscard]] const SessionLoss& loss() const { return m_loss; }
    /// The reason why the last statement failed if the file's content is not to blame: it or a file
    /// beside it could not be opened or read.
    [[nodiscard]] std::optional<Error> failureOutside() const;

private:
    explicit SessionDatabase(QString path);
    void leaveWal();
    void leaveWalOfLostName();
    void closeAt(const QString& file);
    [[nodiscard]] bool goesWith(const QString& file) const;
    [[nodiscard]] Result<QString> copyPrivately();
    [[nodiscard]] Result<void> connect(const QString& name, const QString& options);
    [[nodiscard]] Result<void> checkFormat();
    [[nodiscard]] Result<void> checkSchema(int format);
    [[nodiscard]] Result<void> beginWriting();
    [[nodiscard]] tl::unexpected<Error> failed() const;

    QString m_path; ///< the path for messages
    QString m_file; ///< the file that is open: that one, or a private copy
    std::unique_ptr<QTemporaryDir> m_copy;
    SessionUse m_use; ///< while this process writes it
    SessionLoss m_loss;
    bool m_readOnly = false;
    bool m_hasLeftName = false;
    // While it is written:
    FollowedFile m_followed;
    FollowedFile m_wal;
    SqliteConnection m_connection; ///< last, so that it is closed before the copy and the lock go
};

} // namespace core
