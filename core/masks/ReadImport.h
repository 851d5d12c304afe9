// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/segments/ImportMask.h"
#include "core/masks/MaskOnVolume.h"

namespace core {

/// An importMask edit that contains the voxels of its file; the file is named without a folder.
struct ReadImport {
    ImportMask edit;
    std::vector<MaskNote> notes; ///< MaskOnVolume::notes
    /// Which segments get the voxels, notesOnOverlaps() tells. Empty if all become one segment.
    std::vector<MaskOverlap> overlaps{};
};

/// Reads the file that an importMask names.
/// @param segmentsBefore number of existing segments; if the file has no colours, they continue
/// from there
/// Errors: those of readMask(), UnsupportedFormat (too ragged to be stored).
[[nodiscard]] Result<ReadImport> readImport(const ImportMask& edit, const Volume& volume,
    std::size_t segmentsBefore, const Progress& progress);

} // namespace core
