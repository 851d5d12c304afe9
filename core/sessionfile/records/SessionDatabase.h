// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sessionfile/records/SessionUse.h"
#include "core/sessionfile/records/SqliteConnection.h"

#include <QString>
#include <QVariant>

#include <functional>
#include <memory>
#include <optional>

class QSqlQuery;
class QTemporaryDir;

namespace core {

/// A session file as a database: how it is opened, checked, locked and left (README.md beside this
/// file). Knows nothing of rows. Belongs to the thread that made it. One that was built so that
/// reading it would never end is damaged.
class SessionDatabase {
public:
    static constexpr int applicationId = 0x4275726E; // "Burn"

    /// @pre the file exists and is empty
    static Result<std::unique_ptr<SessionDatabase>> create(const QString& path);
    /// For reading only, neither the file nor its folder is touched: one that is in use or was not
    /// closed is read from a private copy. One that is cut off can only be read.
    static Result<std::unique_ptr<SessionDatabase>> open(const QString& path, bool readOnly);
    /// For writing, on a private copy that goes away with this.
    static Result<std::unique_ptr<SessionDatabase>> openCopy(const QString& path);
    ~SessionDatabase(); ///< leaves one file

    /// One statement with its values for `?`. @return false: see reason()
    bool run(const QString& sql, const QVariantList& values = {});
    /// Calls @p take for every row of an answer; stops when it returns false.
    bool query(const QString& sql, const QVariantList& values,
        const std::function<bool(const QSqlQuery&)>& take);
    /// @p work in one transaction, which is rolled back when it returns false.
    bool transaction(const std::function<bool()>& work);
    /// Before a row is written, in its transaction: a file of before gets the table of titles.
    bool makeRoomForTitles();
    /// Looks through the structure of a file of usual size (PRAGMA quick_check), which is done by
    /// itself before one is written. What is wrong with it is noted in loss(). Errors, where the
    /// file is to be written: SessionDamaged.
    [[nodiscard]] Result<void> checkStructure();
    /// Everything into another file, which is empty or not there yet.
    bool copyInto(const QString& path);
    /// Every table but the images into a session file that holds no row. The source's JSON is
    /// copied as it stands, for the chain hangs on it.
    bool copyHistoryInto(const QString& path);

    [[nodiscard]] QString reason() const { return m_connection.failure().reason; }
    /// What the file lacks; of one that is cut off what is there is read.
    [[nodiscard]] const SessionLoss& loss() const { return m_loss; }
    /// Why the last statement failed, where that is nothing in the file: it, or one beside it,
    /// could not be opened or read.
    [[nodiscard]] std::optional<Error> failureOutside() const;

private:
    explicit SessionDatabase(QString path);
    void leaveWal();
    [[nodiscard]] Result<QString> copyPrivately();
    [[nodiscard]] Result<void> connect(const QString& name, const QString& options);
    [[nodiscard]] Result<void> checkFormat();
    [[nodiscard]] Result<void> checkSchema(int format);
    [[nodiscard]] Result<void> beginWriting();
    [[nodiscard]] tl::unexpected<Error> failed() const;

    QString m_path; ///< what people know it by
    QString m_file; ///< what is open: that, or a private copy
    std::unique_ptr<QTemporaryDir> m_copy;
    SessionUse m_use; ///< while this process writes it
    SessionLoss m_loss;
    bool m_readOnly = false;
    SqliteConnection m_connection; ///< last: closed while the copy and the lock are there
};

} // namespace core
