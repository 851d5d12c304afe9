// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QMultiHash>
#include <QString>
#include <QStringList>

namespace app {

/// One attempt at a study of a batch. It writes into hidden folders, one in each folder that
/// results go to; files get their final names only when the attempt is over. So a killed attempt
/// leaves nothing but hidden folders, and the record names them.
///
/// An existing file with the name of a result is replaced only if an earlier attempt at this study
/// made it and nobody has changed it since. The record's checksums show that.
class StudyAttempt {
public:
    /// @param folder of the study's results; it exists
    /// @param session name of the session's file in it
    /// @param recipe filled, as JSON
    /// @param earlier the study's record so far
    StudyAttempt(const QString& folder, QString session, const QByteArray& recipe,
        const QJsonObject& earlier);
    StudyAttempt(const StudyAttempt&) = delete;
    StudyAttempt& operator=(const StudyAttempt&) = delete;
    ~StudyAttempt();

    /// Removes hidden folders of a killed attempt. Errors: FileUnwritable.
    [[nodiscard]] core::Result<void> removeLeft() const;
    /// Checks that every result may get its name. Errors: FileUnwritable (a file that must not be
    /// replaced has the name).
    [[nodiscard]] core::Result<void> check() const;
    /// Adds to the record what a later attempt must know: "attempt", the hidden folders, and
    /// "made", the files that attempts have made or are about to make. Write the record before
    /// begin() and before place().
    void noteIn(QJsonObject& record) const;
    /// Makes empty hidden folders, with the recipe that writes to them. Errors: FileUnwritable.
    [[nodiscard]] core::Result<void> begin();

    [[nodiscard]] QString recipePath() const;
    [[nodiscard]] QString sessionPath() const;
    /// Returns a text of the child process with hidden paths replaced by the names that the files
    /// will get.
    [[nodiscard]] QString told(QString text) const;

    /// Whether the child process has written a session and could not close it.
    [[nodiscard]] bool isSessionLeftOpen() const;
    /// Closes the session if its disk failed when the child process closed it.
    /// @return false: it is still open, and no result
    [[nodiscard]] bool closeSession() const;
    /// Computes the checksums of the files that were written. Errors: FileUnreadable.
    [[nodiscard]] core::Result<void> survey();
    /// Gives the files of survey() their final names. Errors: FileExists, FileUnwritable.
    [[nodiscard]] core::Result<void> place() const;
    /// Adds "exports" and "sessionSha256" to the record, and keeps in "made" other files of earlier
    /// attempts that still exist.
    void concludeIn(QJsonObject& record) const;
    /// Removes the hidden folders.
    void discard() const;

private:
    [[nodiscard]] QString hidden(const QString& place) const;
    [[nodiscard]] QString staged(const QString& place) const;
    [[nodiscard]] QStringList entries(const QString& place) const;
    [[nodiscard]] QString nameOf(const QString& file) const;
    [[nodiscard]] bool isOurs(const QString& target) const;
    [[nodiscard]] core::Result<void> checkTarget(const QString& target) const;
    [[nodiscard]] core::Result<void> placeOne(
        const QString& from, const QString& place, const QString& name) const;

    QStringList m_places; ///< the folders that results go to; first the study's own
    QString m_session;
    QString m_name; ///< name of the hidden folder in each of them
    QByteArray m_recipe; ///< the recipe, changed to write into the hidden folders
    /// Absolute names of all results; first the session.
    QStringList m_targets;
    QStringList m_left; ///< hidden folders of an earlier attempt
    QMultiHash<QString, QString> m_made; ///< checksums of files that attempts have made, by name
    QJsonArray m_exports;
    QString m_sessionSha256;
};

} // namespace app
