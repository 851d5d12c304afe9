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
    /// The plane of each segment if all keep what they share (planesFor()). Empty if none overlap.
    std::vector<int> planes{};

    /// How many label planes the segments need to keep what they share.
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

/// Whether an import says what becomes of voxels that several segments have, for whoever cannot
/// ask. Errors: UnsupportedFormat (the segments need too many planes, and no order is given).
[[nodiscard]] Result<void> checkOverlaps(const ReadImport& read);

} // namespace core
