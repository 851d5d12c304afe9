// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QVariant>

#include <cstdint>
#include <functional>

class QSqlQuery;

namespace core {

/// One connection to an SQLite file, which may be a stranger's: statements, transactions, and why
/// the last of them failed. Belongs to the thread that made it.
///
/// No statement does more work than a file of its size can give it: one that was built so that
/// reading it would never end fails.
class SqliteConnection {
public:
    struct Failure {
        QString reason;
        QString code; ///< SQLite's result code
    };

    SqliteConnection();
    SqliteConnection(const SqliteConnection&) = delete;
    SqliteConnection& operator=(const SqliteConnection&) = delete;
    ~SqliteConnection(); ///< closes

    /// @param name a path, or an address where @p options say so
    /// @param file that it is of, for its size
    [[nodiscard]] bool open(const QString& name, const QString& options, const QString& file);
    /// SQLite's own door for files by strangers; before the first statement that reads the schema.
    [[nodiscard]] bool harden();
    [[nodiscard]] bool wasOpened() const;
    /// Where the system refuses writing, SQLite opens a file for reading, and forgets why.
    [[nodiscard]] bool isForReading() const;
    /// Of a file that is cut off what is there is read: else SQLite refuses one that has fewer
    /// pages than it says.
    void readCutOff();
    /// Said from now on of what fails, in place of SQLite's words; empty: those.
    void explainBy(const QString& reason) { m_explanation = reason; }

    /// One statement with its values for `?`. @return false: see failure()
    bool run(const QString& sql, const QVariantList& values = {});
    /// Calls @p take for every row of an answer; stops when it returns false.
    bool query(const QString& sql, const QVariantList& values,
        const std::function<bool(const QSqlQuery&)>& take);
    /// @p work in one transaction, which is rolled back when it returns false.
    bool transaction(const std::function<bool()>& work);
    /// The value of a pragma; −1: it cannot be read.
    [[nodiscard]] int number(const char* pragma);

    [[nodiscard]] const Failure& failure() const { return m_failure; }
    void setFailure(const Failure& failure) { m_failure = failure; }
    /// With what SQLite keeps beside the file.
    [[nodiscard]] std::int64_t bytesOnDisk() const;

private:
    [[nodiscard]] bool goesOnForEver();

    QString m_name; ///< Qt's, of the connection
    QString m_file;
    QString m_explanation;
    Failure m_failure;
    std::int64_t m_work = 0; ///< of the statement that runs, in SQLite's instructions
};

} // namespace core
