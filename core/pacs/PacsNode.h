// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

namespace core {

/// How the connection to a node is secured. Files are PEM.
struct PacsTls {
    /// Certificates of the authority that signed the node's; empty: no TLS. DCMTK does not compare
    /// host names, so the authority should have signed only the node's certificate.
    QString authorityFile;
    QString certificateFile; ///< our own, if the node requires one; with keyFile and authorityFile
    QString keyFile;

    [[nodiscard]] bool wanted() const { return !authorityFile.isEmpty(); }
};

/// A DICOM application that accepts C-ECHO, C-FIND, C-GET, C-MOVE or C-STORE.
struct PacsNode {
    QString aeTitle; ///< its title
    QString host;
    int port = 104;
    QString ownAeTitle = QStringLiteral("BURIN"); ///< our title at the node
    int timeoutSeconds = 30; ///< without any response
    PacsTls tls;

    /// "AETITLE@host:port"
    [[nodiscard]] QString name() const;
    /// Parses what name() returns. Errors: InvalidField.
    [[nodiscard]] static Result<PacsNode> parse(const QString& text);
    /// Errors: InvalidField for a title that DICOM does not allow (it has 1 to 16 ASCII characters
    /// and no backslash), an invalid port, or files for TLS of which one is missing.
    [[nodiscard]] Result<void> check() const;
};

} // namespace core
