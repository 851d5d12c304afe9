// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/segments/ImportMask.h"
#include "core/masks/MaskOnVolume.h"

namespace core {

/// An importMask that holds the voxels of its file, which it names without a folder.
struct ReadImport {
    ImportMask edit;
    QStringList notes; ///< MaskOnVolume::notes
};

/// Reads the file that an importMask names.
/// @param segmentsBefore how many there are: where the file names no colours, they go on from there
/// Errors: those of readMask(), UnsupportedFormat (too ragged to be kept).
[[nodiscard]] Result<ReadImport> readImport(const ImportMask& edit, const Volume& volume,
    std::size_t segmentsBefore, const Progress& progress);

} // namespace core
