// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/pacs/PacsNode.h"

#include <QStringList>

namespace core {

/// What a node took.
struct SentObjects {
    int sent = 0;
    QStringList warnings; ///< a sentence for each object that it took, but not as it is
};

/// Stores DICOM files at a node (C-STORE), each in the transfer syntax it has; the node may take
/// uncompressed ones in another uncompressed syntax. Ends at the first that it does not take. Waits
/// for the network; call it on a worker's thread.
///
/// Errors: FileUnreadable and the like (nothing was sent yet), as of Association::request(),
/// NodeRefuses, NodeFailed.
[[nodiscard]] Result<SentObjects> sendFiles(
    const PacsNode& node, const QStringList& files, const Progress& progress);

} // namespace core
