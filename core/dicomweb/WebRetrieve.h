// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicomweb/WebNode.h"
#include "core/pacs/retrieve/PacsRetrieve.h"

namespace core {

/// Retrieves objects by WADO-RS, as retrieve() does from a DICOM node: the target appears when all
/// objects are there and sound, and objects left by an earlier call are not retrieved again. If the
/// connection ends, it is opened again after pauses, as often as the node's settings say.
///
/// Parts are written to the disk as they arrive; memory depends neither on their size nor on their
/// number. Errors: those of WebConnection; NodeNonsense, NodeHasNone, TransferIncomplete,
/// FileUnwritable.
[[nodiscard]] Result<Retrieved> retrieve(
    const WebNode& node, const RetrieveWish& wish, const QString& target, const Progress& progress);

} // namespace core
