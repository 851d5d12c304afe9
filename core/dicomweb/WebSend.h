// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicomweb/WebNode.h"
#include "core/pacs/PacsSend.h"

namespace core {

/// Stores DICOM files unchanged by STOW-RS, as sendFiles() does at a DICOM node. Errors:
/// FileUnreadable and similar (then nothing was sent), those of WebConnection; NodeNonsense, also
/// for an answer that is neither JSON nor XML; NodeFailed, also if an answer in JSON does not name
/// the object as stored. Answers that are empty, or in XML, are believed.
[[nodiscard]] Result<SentObjects> sendFiles(
    const WebNode& node, const QStringList& files, const Progress& progress);

} // namespace core
