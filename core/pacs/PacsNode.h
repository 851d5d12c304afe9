// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

namespace core {

/// How the connection to a node is secured. Files are PEM.
struct PacsTls {
    /// Certificates of the authority that signs the node's; empty: no TLS. DCMTK compares no host
    /// names, so this should sign the node's certificate only.
    QString authorityFile;
    QString certificateFile; ///< our own, where the node asks for it
    QString keyFile;

    [[nodiscard]] bool wanted() const { return !authorityFile.isEmpty(); }
};

/// A DICOM application that answers to C-ECHO, C-FIND, C-GET, C-MOVE or C-STORE.
struct PacsNode {
    QString aeTitle; ///< what it is called
    QString host;
    int port = 104;
    QString ownAeTitle = QStringLiteral("BURIN"); ///< what it knows us by
    int timeoutSeconds = 30; ///< without a sign of life
    PacsTls tls;

    /// "AETITLE@host:port"
    [[nodiscard]] QString name() const;
    /// Reads what name() gives. InvalidField.
    [[nodiscard]] static Result<PacsNode> parse(const QString& text);
    /// InvalidField: a title that DICOM cannot hold (1 to 16 characters of ASCII, no backslash), a
    /// port that is none.
    [[nodiscard]] Result<void> check() const;
};

} // namespace core
