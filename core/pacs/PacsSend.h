// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/pacs/PacsNode.h"

#include <QStringList>

namespace core {

/// What a node accepted.
struct SentObjects {
    int sent = 0;
    QStringList warnings; ///< a sentence for each object that it accepted with changes
};

/// Stores DICOM files at a node (C-STORE), each in its own transfer syntax; uncompressed files may
/// be sent in another uncompressed syntax. Stops at the first file that is not accepted. Blocks;
/// call it on a worker thread.
///
/// Errors: FileUnreadable and similar (then nothing was sent), those of Association::request(),
/// NodeRefuses, NodeFailed.
[[nodiscard]] Result<SentObjects> sendFiles(
    const PacsNode& node, const QStringList& files, const Progress& progress);

} // namespace core
