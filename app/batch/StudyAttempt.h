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
/// results go to, and its files get their names when the attempt is over: of an attempt that was
/// killed, nothing but hidden folders is left, which the record names.
///
/// Whatever has the name of a result is replaced only if an attempt at this study made it and
/// nobody has changed it since; the record tells by checksums.
class StudyAttempt {
public:
    /// @param folder of the study's results; it exists
    /// @param session the session's name in it
    /// @param recipe filled
    /// @param earlier the record of this study so far
    StudyAttempt(const QString& folder, QString session, const QByteArray& recipe,
        const QJsonObject& earlier);
    StudyAttempt(const StudyAttempt&) = delete;
    StudyAttempt& operator=(const StudyAttempt&) = delete;
    ~StudyAttempt();

    /// Removes the hidden folders that an earlier attempt left. Errors: FileUnwritable.
    [[nodiscard]] core::Result<void> removeLeft() const;
    /// Whether a result may have its name. Errors: FileUnwritable (what is there stays).
    [[nodiscard]] core::Result<void> check() const;
    /// Adds what a later attempt has to know: "attempt", the hidden folders, and "made", the files
    /// that attempts have made or are about to. The record is written before either happens.
    void noteIn(QJsonObject& record) const;
    /// Makes the hidden folders, empty, with the recipe that writes to them. Errors:
    /// FileUnwritable.
    [[nodiscard]] core::Result<void> begin();

    [[nodiscard]] QString recipePath() const;
    [[nodiscard]] QString sessionPath() const;
    /// What the child said, with the names that its files will have.
    [[nodiscard]] QString told(QString text) const;

    /// Takes the checksums of what was written. Errors: FileUnreadable.
    [[nodiscard]] core::Result<void> survey();
    /// Gives what was surveyed its names. Errors: FileExists, FileUnwritable.
    [[nodiscard]] core::Result<void> place() const;
    /// Adds "exports" and "sessionSha256", and keeps in "made" what is there besides.
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
    QString m_name; ///< of the hidden folder in each
    QByteArray m_recipe; ///< that writes to them
    QStringList m_targets;
    QStringList m_left; ///< hidden folders of an earlier attempt
    QMultiHash<QString, QString> m_made; ///< checksums by name
    QJsonArray m_exports;
    QString m_sessionSha256;
};

} // namespace app
