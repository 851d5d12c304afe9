// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"
#include "core/document/Document.h"
#include "core/masks/MaskNote.h"
#include "core/masks/MaskOverlap.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace core {

/// One segment of a mask file, as voxels of the open volume. Segments may overlap.
struct MaskSegment {
    QString name;
    std::optional<std::uint32_t> rgb; ///< 0xRRGGBB; none: the file has none
    CodedConcept code;
    VoxelRuns voxels; ///< never empty
};

/// The contents of a mask file on the grid of a volume.
struct MaskOnVolume {
    std::vector<MaskSegment> segments; ///< in the file's order; at least one
    std::vector<MaskNote> notes; ///< what was resampled, left out or assumed
    /// Overlaps of the segments; the notes state only their number of voxels.
    std::vector<MaskOverlap> overlaps{};
};

/// Reads a mask in any known format. NIfTI, NRRD (also .seg.nrrd) and MetaImage labels and STL,
/// OBJ, PLY and glTF surfaces are recognised by file name; anything else is read as DICOM SEG or RT
/// Structure Set. If the grids differ, the nearest voxel decides (LatticeMap.h); for surfaces,
/// voxel centres do (SurfaceFill.h). The file is closed afterwards. Any thread. Errors: those of
/// the readers; UnsupportedFormat (no labels, no segment, or nothing inside the volume). All name
/// the file.
///
/// A folder is read as the mask of all its mask files (maskFilesIn()), as networks write them: one
/// for each structure. A file with a single segment gives it its name. Files without a voxel in the
/// study are left out, and so are images, such as the study itself beside its masks; the notes say
/// so. A file that cannot be read is an error.
[[nodiscard]] Result<MaskOnVolume> readMask(
    const QString& path, const Volume& volume, const Progress& progress);

/// Whether a file or folder was refused because it holds an image, or slices, and no mask.
[[nodiscard]] bool saysImage(const Error& error);

/// The files of a folder that have a name of a mask (maskNamePatterns()), sorted by name; without
/// those of folders inside it. Empty if there are none, or if the path is no folder.
[[nodiscard]] QStringList maskFilesIn(const QString& path);

/// The file names of masks as a file dialog needs them: "*.nii", …
[[nodiscard]] QStringList maskNamePatterns();

/// Whether a DICOM SOP class contains masks.
[[nodiscard]] bool isMaskClass(const QString& sopClassUid);

} // namespace core
