// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QString>
#include <QVariant>

#include <cstdint>
#include <functional>

class QSqlQuery;

namespace core {

/// One connection to an SQLite file: statements, transactions, and why the last of them failed. The
/// file may come from a stranger: a statement that does more work than a file of its size can
/// require fails, so that none runs for ever. Belongs to the thread that created it.
class SqliteConnection {
public:
    struct Failure {
        Clause reason;
        QString code; ///< SQLite's result code
    };

    SqliteConnection();
    SqliteConnection(const SqliteConnection&) = delete;
    SqliteConnection& operator=(const SqliteConnection&) = delete;
    ~SqliteConnection(); ///< closes

    /// @param name a path, or a URI if @p options say so
    /// @param file the file itself, for its size
    [[nodiscard]] bool open(const QString& name, const QString& options, const QString& file);
    /// Enables SQLite's protection against hostile files; before the first statement that reads the
    /// schema.
    [[nodiscard]] bool harden();
    [[nodiscard]] bool wasOpened() const;
    /// Lets go of the file and of its locks; no statement may follow.
    void close();
    /// Whether the file was opened for reading only. SQLite does that if the system refuses
    /// writing, and does not keep the reason.
    [[nodiscard]] bool isForReading() const;
    /// Reads the existing part of a file that is cut off; SQLite otherwise refuses a file with
    /// fewer pages than its header states.
    void readCutOff();
    /// Replaces SQLite's message for later failures; empty: use SQLite's.
    void explainBy(const Clause& reason) { m_explanation = reason; }

    /// Runs one statement with its values for `?`. @return false: see failure()
    bool run(const QString& sql, const QVariantList& values = {});
    /// Calls @p take for every row of the answer, until it returns false.
    bool query(const QString& sql, const QVariantList& values,
        const std::function<bool(const QSqlQuery&)>& take);
    /// Runs @p work in one transaction, which is rolled back if it returns false.
    bool transaction(const std::function<bool()>& work);
    /// The value of a pragma; −1: it cannot be read.
    [[nodiscard]] int number(const char* pragma);

    [[nodiscard]] const Failure& failure() const { return m_failure; }
    void setFailure(const Failure& failure) { m_failure = failure; }
    /// Including the files that SQLite keeps beside it.
    [[nodiscard]] std::int64_t bytesOnDisk() const;

private:
    [[nodiscard]] bool goesOnForEver();

    QString m_name; ///< name of the connection in Qt
    QString m_file;
    Clause m_explanation;
    Failure m_failure;
    std::int64_t m_work = 0; ///< of the running statement, in SQLite's instructions
};

} // namespace core
