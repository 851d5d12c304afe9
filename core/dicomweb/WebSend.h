// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicomweb/WebNode.h"
#include "core/pacs/PacsSend.h"

namespace core {

/// Stores DICOM files by STOW-RS, as they are, as sendFiles() does at a DICOM node.
/// Errors: FileUnreadable and the like (nothing was sent yet), as of WebConnection, NodeFailed.
[[nodiscard]] Result<SentObjects> sendFiles(
    const WebNode& node, const QStringList& files, const Progress& progress);

} // namespace core
