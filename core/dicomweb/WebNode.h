// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QByteArray>
#include <QString>
#include <QUrl>

namespace core {

/// The login at a web server. It never becomes part of a name, an address, a message or the
/// settings.
struct WebLogin {
    QString user; ///< HTTP Basic
    QString password;
    QString token; ///< HTTP Bearer, instead of both

    [[nodiscard]] bool isGiven() const { return !user.isEmpty() || !token.isEmpty(); }
    /// The value of the header "Authorization"; empty if no login is given.
    [[nodiscard]] QByteArray header() const;
    /// Parses "user:password" or "Bearer TOKEN". Errors: InvalidField, which does not contain the
    /// text.
    [[nodiscard]] static Result<WebLogin> parse(const QString& text);
    /// Reads the first line of a file that only its owner can read. Errors: FileNotFound,
    /// FileUnreadable (also if others can read it), InvalidField.
    [[nodiscard]] static Result<WebLogin> read(const QString& file);
};

/// A server that speaks DICOMweb (PS3.18): QIDO-RS, WADO-RS, STOW-RS.
struct WebNode {
    QUrl url; ///< the part before "/studies"
    WebLogin login;
    QString loginFile; ///< read for each operation if `login` is not given
    /// Certificates (PEM) of the authority that signed the server's; empty: those trusted by the
    /// system.
    QString authorityFile;
    QString certificateFile; ///< our own, if the server requires one
    QString keyFile;
    int timeoutSeconds = 30; ///< without any response
    int retries = 3; ///< if the server is busy or the connection ends
    int firstPauseMs = 500; ///< before the first retry; doubled each time

    /// "https://host/dicom-web"
    [[nodiscard]] QString name() const { return url.toString(QUrl::RemoveUserInfo); }
    /// Whether a text is meant as the address of a web server.
    [[nodiscard]] static bool isAddress(const QString& text);
    /// Parses an address. Errors: InvalidField (no address, or one with a password in it).
    [[nodiscard]] static Result<WebNode> parse(const QString& text);
    /// InvalidField.
    [[nodiscard]] Result<void> check() const;
};

} // namespace core
