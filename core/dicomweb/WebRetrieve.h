// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicomweb/WebNode.h"
#include "core/pacs/retrieve/PacsRetrieve.h"

namespace core {

/// Fetches objects by WADO-RS as retrieve() does from a DICOM node: the target comes into being
/// when all are there and sound, what an earlier call left is not fetched again. A connection that
/// ends amid the work is taken up again by itself, after pauses, as often as the node says.
///
/// Parts go to the disk as they arrive: memory does not depend on their size or number.
/// Errors: as of WebConnection; NodeNonsense, NodeHasNone, TransferIncomplete, FileUnwritable.
[[nodiscard]] Result<Retrieved> retrieve(
    const WebNode& node, const RetrieveWish& wish, const QString& target, const Progress& progress);

} // namespace core
