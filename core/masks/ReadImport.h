// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/imports/ImportMask.h"
#include "core/masks/MaskOnVolume.h"

namespace core {

/// An importMask edit that contains the voxels of its file; the file is named without a folder.
struct ReadImport {
    ImportMask edit;
    std::vector<MaskNote> notes; ///< MaskOnVolume::notes
    /// Overlaps of its segments; notesOnOverlaps() says which segments get the voxels. Empty if all
    /// become one segment.
    std::vector<MaskOverlap> overlaps{};
    /// The label plane of each segment if all are to keep their voxels (planesFor()). Empty if none
    /// overlap.
    std::vector<int> planes{};

    /// The number of label planes that are needed for this.
    [[nodiscard]] int planesNeeded() const;
};

/// Reads the file that an importMask names. Where its segments overlap and the edit names neither
/// planes nor an order, they keep what they share: ImportMask::planes says where. If they need more
/// planes than there can be, it stays unset.
/// @param segmentsBefore number of existing segments; if the file has no colours, they continue
/// from there
/// Errors: those of readMask(), UnsupportedFormat (too ragged to be stored).
[[nodiscard]] Result<ReadImport> readImport(const ImportMask& edit, const Volume& volume,
    std::size_t segmentsBefore, const Progress& progress);

/// Checks that an import states what happens to voxels that several segments share. For callers
/// that cannot ask the user. Errors: UnsupportedFormat (the segments need too many planes, and no
/// order is given).
[[nodiscard]] Result<void> checkOverlaps(const ReadImport& read);

} // namespace core
