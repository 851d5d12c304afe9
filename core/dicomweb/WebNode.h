// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QByteArray>
#include <QString>
#include <QUrl>

namespace core {

/// Who we are to a web server. Never part of a name, an address, a message or the settings.
struct WebLogin {
    QString user; ///< HTTP Basic
    QString password;
    QString token; ///< HTTP Bearer, instead of both

    [[nodiscard]] bool isGiven() const { return !user.isEmpty() || !token.isEmpty(); }
    /// The value of the header "Authorization"; empty where nothing is given.
    [[nodiscard]] QByteArray header() const;
    /// Reads "user:password" or "Bearer TOKEN". InvalidField, which does not repeat it.
    [[nodiscard]] static Result<WebLogin> parse(const QString& text);
    /// Reads the first line of a file that its owner keeps to himself. FileNotFound,
    /// FileUnreadable, also where others may read it; InvalidField.
    [[nodiscard]] static Result<WebLogin> read(const QString& file);
};

/// A server that speaks DICOMweb (PS3.18): QIDO-RS, WADO-RS, STOW-RS.
struct WebNode {
    QUrl url; ///< what stands before "/studies"
    WebLogin login;
    QString loginFile; ///< read for each piece of work, where `login` is not given
    /// Certificates (PEM) of the authority that signs the server's; empty: those the system trusts.
    QString authorityFile;
    QString certificateFile; ///< our own, where the server asks for it
    QString keyFile;
    int timeoutSeconds = 30; ///< without a sign of life
    int retries = 3; ///< when it is busy, or the connection ends
    int firstPauseMs = 500; ///< before the first of them; doubled each time

    /// "https://host/dicom-web"
    [[nodiscard]] QString name() const { return url.toString(QUrl::RemoveUserInfo); }
    /// Whether a word is meant as the address of one.
    [[nodiscard]] static bool isAddress(const QString& text);
    /// Reads an address. InvalidField: no address, or one with a password in it.
    [[nodiscard]] static Result<WebNode> parse(const QString& text);
    /// InvalidField.
    [[nodiscard]] Result<void> check() const;
};

} // namespace core
